// One test for each warning, with what must not give it.

#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

TEST_CASE("a step that nothing can activate") {
    CHECK(messages_of(R"(
input a
graph G {
  initial 1
  step 2
  step 3
  step 4
  step 5
  step 6
  step 7
  1 -> 2 : a
  2 -> 1 : a
  3 -> 4 : a
  1, 3 -> 5 : a
  2 -> 6 : a . /a
  6 -> 7 : a
  4 -> 1 : a
  5 -> 1 : a
  7 -> 1 : a
}
)") == R"(6:8 warning: nothing can activate step '3': it is not initial, and no transition, forcing order or activation link that can come about leads to it
7:8 warning: nothing can activate step '4': it is not initial, and no transition, forcing order or activation link that can come about leads to it
8:8 warning: nothing can activate step '5': it is not initial, and no transition, forcing order or activation link that can come about leads to it
9:8 warning: nothing can activate step '6': it is not initial, and no transition, forcing order or activation link that can come about leads to it
10:8 warning: nothing can activate step '7': it is not initial, and no transition, forcing order or activation link that can come about leads to it
15:3 warning: the transition condition of transition '4' is constantly 0, so it is never cleared
)");
}

TEST_CASE("forcing orders and activation links activate steps") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 : H{3} step 2 encloses K{5} step 9 : H{8} 1 -> 2 : a 2 -> 1 : a }
graph H { step 3 step 4 step 8 3 -> 4 : a 4 -> 3 : a 8 -> 8 : a }
graph K { step 5 step 6 5 -> 5 : a 6 -> 6 : a }
)") == R"(3:54 warning: nothing can activate step '9': it is not initial, and no transition, forcing order or activation link that can come about leads to it
4:30 warning: nothing can activate step '8': it is not initial, and no transition, forcing order or activation link that can come about leads to it
5:23 warning: nothing can activate step '6': it is not initial, and no transition, forcing order or activation link that can come about leads to it
)");
}

TEST_CASE("a graph without an initial step that nothing forces") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 : I{*}, J{7}, K{} 1 -> 1 : a }
graph H { step 2 step 3 2 -> 3 : a 3 -> 2 : a }
graph I { step 5 5 -> 5 : a }
graph J { step 7 7 -> 7 : a }
graph K { step 8 8 -> 8 : a }
graph L { step 9 -> 9 : ↑a 9 -> : a }
graph M { }
)") == R"(4:7 warning: graph 'H' has no initial step and nothing forces it, so it never becomes active; make a step initial
5:7 warning: graph 'I' has no initial step and nothing forces it, so it never becomes active; make a step initial
7:16 warning: nothing can activate step '8': it is not initial, and no transition, forcing order or activation link that can come about leads to it
9:7 warning: graph 'M' has no initial step and nothing forces it, so it never becomes active; make a step initial
)");
}

TEST_CASE("a receptivity that is constantly 0") {
    CHECK(messages_of(R"(
input a, b, c
counter k : 0..9
graph G {
  initial 1
  1 -> 1 : 0
  1 -> 1 : a . b . /a
  1 -> 1 : (a + b) . /a . /b
  1 -> 1 : ↑a . ↓a
  1 -> 1 : ↑a . /a
  1 -> 1 : ↓a . a
  1 -> 1 : ↑1 + 5s/0 + /1
  1 -> 1 : [k > 9] + [k - 10 >= 0] + [k + 1 = 0]
  1 -> 1 : a ⊕ a
  1 -> 1 : 1 ⊕ 1 ⊕ 0
  1 -> 1 : 5s/a . /a
  1 -> 1 : a ⊕ b ⊕ c ⊕ (a ⊕ b)
  1 -> 1 : [k > 8] . [k <= 9] . ↑a . /b
  (first) 1 -> 1 : 1
  (last) 1 -> 1 : 0 . a
}
)") == R"(6:3 warning: the transition condition of transition '0' is constantly 0, so it is never cleared
7:3 warning: the transition condition of transition '1' is constantly 0, so it is never cleared
8:3 warning: the transition condition of transition '2' is constantly 0, so it is never cleared
9:3 warning: the transition condition of transition '3' is constantly 0, so it is never cleared
10:3 warning: the transition condition of transition '4' is constantly 0, so it is never cleared
11:3 warning: the transition condition of transition '5' is constantly 0, so it is never cleared
12:3 warning: the transition condition of transition '6' is constantly 0, so it is never cleared
13:3 warning: the transition condition of transition '7' is constantly 0, so it is never cleared
14:3 warning: the transition condition of transition '8' is constantly 0, so it is never cleared
15:3 warning: the transition condition of transition '9' is constantly 0, so it is never cleared
20:3 warning: the transition condition of transition 'last' is constantly 0, so it is never cleared
)");
}

TEST_CASE("a stored action on an event without an edge") {
    CHECK(messages_of(R"(
input a
output l, m, n
var v
graph G {
  initial 1 : set l on a, set m on ↑a . X1, set n on 3s/↑a, set v on activation
  1 -> 1 : a . v
}
)") == R"(6:15 warning: the event after 'on' has no edge, so this action runs at every scan in which it is 1; write ↑ or ↓ before what should happen
6:45 warning: the event after 'on' has no edge, so this action runs at every scan in which it is 1; write ↑ or ↓ before what should happen
)");
}

TEST_CASE("a declared name that is never used") {
    CHECK(messages_of(R"(
input a, b, "c d"
output l, m, n
var v, w
counter k : 0..3
counter q : 0..1
assume /(a . "c d")
graph G { initial 1 : l, set v on ↑a 1 -> 1 : [q = q] do reset m }
)") == R"(2:10 warning: input 'b' is declared and never used
3:14 warning: output 'n' is declared and never used
4:8 warning: var 'w' is declared and never used
5:9 warning: counter 'k' is declared and never used
)");
}

TEST_CASE("stored actions that may write in the same scan") {
    CHECK(messages_of(R"(
input a
output l
var v, w
counter k : 0..9
counter n : 0..9
counter p : 0..9
graph G {
  initial 1 : set l, k := k + 1
  step 2 : reset l, set v on deactivation
  step 3 : reset v, w := a on ↑a
  step 4 : n := 0, n := 1
  1 -> 2 : a
  2 -> 3 : a
  3 -> 4 : a do w := v, p := 0
  4 -> 1 : a do reset w, p := p + 1
}
graph H {
  initial 5 : k := 0 on deactivation
  5 -> 5 : l . w . [n + p + k = 0]
}
)") == R"(11:12 warning: several stored actions may write 'v' in the same scan; only the last of them then counts
  10:21 note: another one is here
12:20 warning: several stored actions may write 'n' in the same scan; only the last of them then counts
  12:12 note: another one is here
19:15 warning: several stored actions may write 'k' in the same scan; only the last of them then counts
  9:22 note: another one is here
)");
}

TEST_CASE("in graphs of several tokens any two writes may meet") {
    CHECK(messages_of(R"(
input a
var u, v, w, x, y
graph AND { initial 1 step 2 : set v step 3 : reset v 1 -> 2, 3 : a 2, 3 -> 1 : a . v }
graph SRC { initial 4 : set w step 5 : reset w -> 4 : ↑a 4 -> 5 : a 5 -> : a . w }
graph TWO { initial 6 : set x initial 7 : reset x 6 -> 7 : a 7 -> 6 : a . x }
graph FRC { initial 8 : set y step 9 : reset y 8 -> 9 : a 9 -> 8 : a . y }
graph ENC { initial 10 : set u step 11 : reset u 10 -> 11 : a 11 -> 10 : a . u }
graph TOP { initial 12 : FRC{8, 9} initial 13 encloses ENC{10, 11} 12 -> 12 : a 13 -> 13 : a }
)") == R"(4:47 warning: several stored actions may write 'v' in the same scan; only the last of them then counts
  4:32 note: another one is here
5:40 warning: several stored actions may write 'w' in the same scan; only the last of them then counts
  5:25 note: another one is here
6:43 warning: several stored actions may write 'x' in the same scan; only the last of them then counts
  6:25 note: another one is here
7:40 warning: several stored actions may write 'y' in the same scan; only the last of them then counts
  7:25 note: another one is here
8:42 warning: several stored actions may write 'u' in the same scan; only the last of them then counts
  8:26 note: another one is here
)");
}

TEST_CASE("set in one step and reset in another is no conflict") {
    CHECK(messages_of(R"(
input a, b
output l
var v
graph G {
  initial 1 : set l
  step 2 : reset l, set v on deactivation
  step 3 : set l
  macro M = e
  1 -> 2 : a
  1 -> 3 : b . /a
  2 -> M : a
  3 -> M : b
  M -> 1 : v do reset v
}
expansion e { entry 4 : reset l exit 5 4 -> 5 : a do set v }
)") == R"()");
}
