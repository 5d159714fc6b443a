// One test for each thing the language refuses: the exact words, the place, and the other parties.

#include "grafcet/messages.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

TEST_CASE("unknown names, with the nearest declared one") {
    CHECK(messages_of(R"(
input start, stop
output lamp
counter count : 0..3
graph G {
  initial 1 : lampe, Hh{7}
  step 2 : lamp, H{77}
  1 -> 22 : strat . X22 + [coun = 1] + 2s/2
  1 -> 2 : xyz . 1 + start.stop
  1 -> 2 : 2s/stp do coutn := 0
  macro M = expand
}
graph Hz { initial 7 encloses Gz{2} step 78 7 -> 78 : 1 78 -> 7 : X2 . X1 . G }
expansion expant { entry E exit S E -> S : [count > 0] }
)") == R"(6:15 error: unknown output 'lampe'; did you mean 'lamp'?
6:22 error: unknown graph 'Hh'; did you mean 'Hz'?
7:18 error: unknown graph 'H'
7:20 error: unknown step '77'; did you mean '7'?
8:8 error: unknown step '22'; did you mean '2'?
8:43 error: the number '2' is no condition: the variable of step 2 is X2, and counters are compared in brackets, as in [c = 2]
9:12 error: unknown variable 'xyz'
10:15 error: unknown variable 'stp'; did you mean 'stop'?
10:22 error: unknown output 'coutn'; did you mean 'count'?
11:13 error: unknown expansion 'expand'; did you mean 'expant'?
13:31 error: unknown graph 'Gz'; did you mean 'G'?
13:77 error: unknown variable 'G'; the variable of graph 'G' is XG
14:11 error: no macro-step uses expansion 'expant'; declare one with 'macro M = expant', or remove the expansion
)");
}

TEST_CASE("names declared twice") {
    CHECK(messages_of(R"(
input a, b, a
output b
var Init
counter AUdur : 0..3
graph G { initial 1 1 -> 1 : a . b }
)") == R"(2:13 error: the variable 'a' exists already; rename one of the two
  2:7 note: it is first declared here
3:8 error: the variable 'b' exists already; rename one of the two
  2:10 note: it is first declared here
4:5 error: 'Init' is a control input, which every GRAFCET has without declaring it; remove this declaration or choose another name
5:9 error: 'AUdur' is a control input, which every GRAFCET has without declaring it; remove this declaration or choose another name
)");
}

TEST_CASE("steps, transitions, graphs and expansions of one name") {
    CHECK(messages_of(R"(
input a
graph G {
  initial 1
  step 1
  macro M = e
  macro M = f
  (t) 1 -> M : a
  (t) M -> 1 : a
  1 -> M : a
  (2) M -> 1 : a
  (02) M -> 1 : a
  (3) M -> 1 : a
}
graph G { initial 5 5 -> 5 : a }
expansion e { entry e1 exit e2
(8) e1 -> e2 : a }
expansion e { entry f1 exit f2 f1 -> f2 : a }
expansion f { entry g1 exit g2 g1 -> g2 : a }
)") == R"(5:8 error: the step '1' exists already; step names are unique in the whole file, so rename one of the two
  4:11 note: it is first declared here
7:9 error: the step 'M' exists already; step names are unique in the whole file, so rename one of the two
  6:9 note: it is first declared here
9:4 error: the transition 't' exists already; transition names are unique in the whole file, so rename one of the two
  8:4 note: it is first declared here
11:4 error: the label '2' is also the rank of a transition without a label; label that one too, or choose another label
  10:3 note: this transition has rank 2: it is named '2'
15:7 error: the graph 'G' exists already; rename one of the two
  3:7 note: it is first declared here
17:2 error: the label '8' is also the rank of a transition without a label; label that one too, or choose another label
  18:32 note: this transition has rank 8: it is named '8'
18:11 error: the expansion 'e' exists already; rename one of the two
  16:11 note: it is first declared here
)");
}

TEST_CASE("a step named twice in one list") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 : H{3, 4, 3} step 2 1, 1 -> 2, 2 : a 2 -> 1 : /a }
graph H { initial 3 step 4 3 -> 4 : a 4 -> 3 : /a }
)") == R"(3:31 error: step '3' is named twice in this list; name it once
  3:25 note: it is named here too
3:44 error: step '1' is named twice in this list; name it once
  3:41 note: it is named here too
3:52 error: step '2' is named twice in this list; name it once
  3:49 note: it is named here too
)");
}

TEST_CASE("a transition without any step") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 1 -> 1 : a
  -> : a
  (x) -> := 1
}
)") == R"(4:3 error: this transition has no step before it and none after it; name at least one, as in 1 -> 2
5:3 error: this transition has no step before it and none after it; name at least one, as in 1 -> 2
)");
}

TEST_CASE("a transition that names a step of another graph") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 macro M = e 1 -> M : a M -> 1 : a 1 -> 2, S : a }
graph H { initial 2 2 -> M : a }
expansion e { entry E exit S E -> S : a S -> 1 : a }
)") == R"(3:60 error: step '2' belongs to graph 'H'; a transition of graph 'G' names steps and macro-steps of that graph only
  4:19 note: step '2' is declared here
3:63 error: step 'S' belongs to expansion 'e'; a transition of graph 'G' names steps and macro-steps of that graph only
  5:28 note: step 'S' is declared here
4:26 error: macro-step 'M' belongs to graph 'G'; a transition of graph 'H' names steps and macro-steps of that graph only
  3:27 note: macro-step 'M' is declared here
5:46 error: step '1' belongs to graph 'G'; a transition of expansion 'e' names steps and macro-steps of that expansion only
  3:19 note: step '1' is declared here
)");
}

TEST_CASE("assignment to inputs and to variables of steps") {
    CHECK(messages_of(R"(
input a, "très long"
graph G {
  initial 1 : a, set "très long", Init
  step 2 : AUdur := 1, X1, reset XG
  1 -> 2 : a do set a, X2 := 1
  2 -> 1 : "très long"
}
)") == R"(4:15 error: 'a' is an input, which the GRAFCET reads and never writes; name an output, a var or a counter
4:22 error: 'très long' is an input, which the GRAFCET reads and never writes; name an output, a var or a counter
4:35 error: 'Init' is a control input, which the GRAFCET reads and never writes; name an output, a var or a counter
5:12 error: 'AUdur' is a control input, which the GRAFCET reads and never writes; name an output, a var or a counter
5:24 error: 'X1' follows the situation and is never written; use a forcing order to change the situation of a graph
5:34 error: 'XG' follows the situation and is never written; use a forcing order to change the situation of a graph
6:21 error: 'a' is an input, which the GRAFCET reads and never writes; name an output, a var or a counter
6:24 error: 'X2' follows the situation and is never written; use a forcing order to change the situation of a graph
)");
}

TEST_CASE("a continuous action on a var or a counter") {
    CHECK(messages_of(R"(
input a
var v
counter c : 0..1
graph G { initial 1 : v, c if a, c := 0, set v 1 -> 1 : v . [c = 0] }
)") == R"(5:26 error: continuous action on the counter 'c', which changes by stored actions only; write 'c := c + 1', or declare it as an output
5:46 error: 'v' is held by continuous actions and changed by stored ones; use one kind only
  5:23 note: a continuous action drives it here
)");
}

TEST_CASE("an edge in the condition of a continuous action") {
    CHECK(messages_of(R"(
input a, b
output l, m, k
graph G {
  initial 1 : l if ↑a . b, m if 3s/↑a, k if b + fall(3s/a)
  1 -> 1 : ↑a
}
)") == R"(5:20 error: edge in the condition of a continuous action: it would last one scan only; use a stored action ('set … on ↑…'), or a time condition around the edge
5:49 error: edge in the condition of a continuous action: it would last one scan only; use a stored action ('set … on ↑…'), or a time condition around the edge
)");
}

TEST_CASE("a macro-step in a forcing order or an activation link") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 macro M = e 1 -> M : a M -> 1 : a }
graph H { initial 2 : G{M} step 3 encloses G{M, 1} 2 -> 3 : a 3 -> 2 : a }
expansion e { entry E exit S E -> S : a }
)") == R"(3:19 error: step '1' is initial, but step '3', which encloses its graph 'G', is not; make both initial or neither
  4:33 note: the enclosing step is here
4:25 error: 'M' is a macro-step; a forcing order names steps, such as the entry step of its expansion
4:46 error: 'M' is a macro-step; an activation link names steps, such as the entry step of its expansion
)");
}

TEST_CASE("a continuous output read in an expression") {
    CHECK(messages_of(R"(
input a
output lamp, pump, idle
graph G {
  initial 1 : lamp, set pump
  1 -> 1 : lamp . pump + idle
  1 -> 1 : a do pump := lamp
}
)") == R"(6:12 error: 'lamp' is a continuous output, which cannot be read; write its condition instead, or declare it as a var, which steps hold and conditions read: var lamp
  5:15 note: this continuous action drives it
6:26 error: output 'idle' is read, but no stored action drives it; only stored outputs can be read
7:25 error: 'lamp' is a continuous output, which cannot be read; write its condition instead, or declare it as a var, which steps hold and conditions read: var lamp
  5:15 note: this continuous action drives it
)");
}

TEST_CASE("an output driven by both kinds of action") {
    CHECK(messages_of(R"(
input a
output l, m
graph G {
  initial 1 : l
  step 2 : set l, l := a, set m
  step 3 : m if a
  1 -> 2 : a do reset l
  2 -> 3 : l . m
  3 -> 1 : a
}
)") == R"(6:12 error: output 'l' is driven by continuous and by stored actions; use one kind only
  5:15 note: a continuous action drives it here
7:12 error: output 'm' is driven by continuous and by stored actions; use one kind only
  6:27 note: a stored action drives it here
)");
}

TEST_CASE("orders to unknown graphs, and of steps of other graphs") {
    CHECK(messages_of(R"(
input a
graph Gate { initial 1 : Gait{}, e{*}, H{1}, H{4, 99} 1 -> 1 : a }
graph H { initial 4 4 -> 4 : a macro M = e }
expansion e { entry E : H{4} exit S E -> S : a }
graph K { initial 8 : H{E, S} step 9 encloses H{1, E} step 10 encloses L{1} 8 -> 9, 10 : a }
)") == R"(3:26 error: unknown graph 'Gait'
3:34 error: 'e' is an expansion; orders and enclosures name graphs
3:42 error: step '1' belongs to graph 'Gate', not to graph 'H'; name steps of 'H'
  3:22 note: step '1' is declared here
3:51 error: unknown step '99'; did you mean '9'?
4:19 error: step '4' is initial, but step '9', which encloses its graph 'H', is not; make both initial or neither
  6:36 note: the enclosing step is here
5:25 error: step 'E' forces its own graph 'H'; only another graph can be forced or enclosed
6:49 error: step '1' belongs to graph 'Gate', not to graph 'H'; name steps of 'H'
  3:22 note: step '1' is declared here
6:72 error: unknown graph 'L'
)");
}

TEST_CASE("graphs that force themselves") {
    CHECK(messages_of(R"(
input a
graph A { initial 1 : A{}, A{1}, A{*} 1 -> 1 : a }
graph B { initial 2 2 -> 2 : a macro M = e }
expansion e { entry E exit S : B{INIT} E -> S : a }
graph C { initial 4 : D{} 4 -> 4 : a }
graph D { initial 5 step 6 : "E E"{} 5 -> 6 : a }
graph "E E" { initial 7 : C{INIT} 7 -> 7 : a }
graph F { initial 8 encloses F{8} 8 -> 8 : a }
)") == R"(3:23 error: step '1' forces its own graph 'A'; only another graph can be forced or enclosed
5:32 error: step 'S' forces its own graph 'B'; only another graph can be forced or enclosed
6:23 error: graphs force or enclose one another in a circle: 'C' forces 'D', 'D' forces 'E E', 'E E' forces 'C'; break the circle at one place
  7:30 note: step '6' of 'D' forces 'E E' here
  8:27 note: step '7' of 'E E' forces 'C' here
9:30 error: step '8' encloses its own graph 'F'; only another graph can be forced or enclosed
)");
}

TEST_CASE("circles of forcing orders and enclosures together") {
    CHECK(messages_of(R"(
input a
graph A { initial 1 encloses B{2} 1 -> 1 : a }
graph B { initial 2 : C{} 2 -> 2 : a }
graph C { initial 3 : A{*} step 4 : A{1}, D{*} 3 -> 4 : a 4 -> 3 : a }
graph D { initial 5 : C{*} 5 -> 5 : a }
)") == R"(3:30 error: graphs force or enclose one another in a circle: 'A' encloses 'B', 'B' forces 'C', 'C' forces 'A'; break the circle at one place
  4:23 note: step '2' of 'B' forces 'C' here
  5:37 note: step '4' of 'C' forces 'A' here
)");
}

TEST_CASE("counter ranges") {
    CHECK(messages_of(R"(
input a
counter c : 9..0
counter d : 0..65536
counter e : -32768..32767
counter f : -3..-3
counter g : 0..99999999999999999999
counter h : a..3, i : 0..1
counter k : 0..3, l
graph G { initial 1 1 -> 1 : a . [c + d + e + f + g + k = 0] }
)") == R"(3:9 error: the range 9..0 of counter 'c' is empty; write the lowest value first
4:9 error: the range 0..65536 of counter 'd' spans 65537 values; a counter has 65536 at most
7:16 error: the number '99999999999999999999' is too large; numbers go up to 1000000000000
8:13 error: expected a number for the range of the counter, got 'a'
9:17 error: each counter has a declaration of its own; write 'counter' again
)");
}

TEST_CASE("comparison of something that is not a counter") {
    CHECK(messages_of(R"(
input a
var v
counter c : 0..3
graph G {
  initial 1 : v := c, set c, c := a on ↑a
  1 -> 1 : [a = 1] + [c > v] + [X1 < 2] + [c = 1] + c
  1 -> 1 : [Xx = 1]
}
)") == R"(6:20 error: 'c' is a counter, not a condition; compare it, as in [c > 0]
6:27 error: 'c' is a counter, which is neither set nor reset; write a value, as in c := 0
6:35 error: 'a' is not a counter; only counters and numbers are compared and added
7:13 error: 'a' is not a counter; only counters and numbers are compared and added
7:27 error: 'v' is not a counter; only counters and numbers are compared and added
7:33 error: 'X1' is not a counter; only counters and numbers are compared and added
7:53 error: 'c' is a counter, not a condition; compare it, as in [c > 0]
8:13 error: unknown counter 'Xx'
)");
}

TEST_CASE("a graph enclosed twice, a step that encloses two graphs") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 encloses H{3} initial 2 encloses H{3} 1 -> 2 : a }
graph H { initial 3 3 -> 3 : a }
graph K { initial 4 encloses L{5} encloses M{6} : L{*} 4 -> 4 : a }
graph L { initial 5 5 -> 5 : a }
graph M { initial 6 6 -> 6 : a }
)") == R"(3:54 error: graph 'H' is enclosed by step '1' already; a graph is enclosed by one step at most
  3:19 note: it is first enclosed here
5:35 error: step '4' encloses a graph already; a step encloses one graph at most
)");
}

TEST_CASE("initial steps in the graphs of enclosing steps") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 encloses H{4} step 2 encloses K{5} 1 -> 2 : a 2 -> 1 : a }
graph H { step 4 4 -> 4 : a }
graph K { initial 5 macro M = e 5 -> M : a M -> 5 : a }
expansion e { entry E exit S initial 7 E -> S : a 7 -> S : a }
)") == R"(3:19 error: step '1' is initial, but graph 'H', which it encloses, has no initial step; make both initial or neither
  4:7 note: the enclosed graph is here
5:19 error: step '5' is initial, but step '2', which encloses its graph 'K', is not; make both initial or neither
  3:40 note: the enclosing step is here
6:38 error: step '7' is initial, but step '2', which encloses its graph 'K', is not; make both initial or neither
  3:40 note: the enclosing step is here
)");
}

TEST_CASE("variables of one name") {
    CHECK(messages_of(R"(
input X5, X, XG
output XM
var "Xmy step"
graph G {
  initial 5
  step "my step"
  macro M = e
  step H
  5 -> H : X5 . X . XG
}
graph H { initial 6 6 -> 6 : XH do set "Xmy step" }
expansion e { entry E : XM exit S E -> S : 1 }
)") == R"(5:7 error: input 'XG' and graph 'G' both have the variable 'XG'; rename one of them
  2:14 note: input 'XG' is declared here
6:11 error: input 'X5' and step '5' both have the variable 'X5'; rename one of them
  2:7 note: input 'X5' is declared here
7:8 error: var 'Xmy step' and step 'my step' both have the variable 'Xmy step'; rename one of them
  4:5 note: var 'Xmy step' is declared here
8:9 error: output 'XM' and macro-step 'M' both have the variable 'XM'; rename one of them
  3:8 note: output 'XM' is declared here
12:7 error: step 'H' and graph 'H' both have the variable 'XH'; rename one of them
  9:8 note: step 'H' is declared here
)");
}

TEST_CASE("expansions without their ends") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 macro M = e macro N = f 1 -> M : a M -> N : a N -> 1 : a entry E9 }
expansion e { entry E1 entry E2 E1 -> E2 : a }
expansion f { exit S1 exit S2 exit S3 S1 -> S2 : a }
)") == R"(3:78 error: 'entry' stands in an expansion only; in a graph write 'step'
4:11 error: expansion 'e' has no exit step; declare it with 'exit S1'
4:30 error: expansion 'e' has a second entry step; an expansion has exactly one
  4:21 note: the first one is here
5:11 error: expansion 'f' has no entry step; declare it with 'entry E1'
5:28 error: expansion 'f' has a second exit step; an expansion has exactly one
  5:20 note: the first one is here
5:36 error: expansion 'f' has a second exit step; an expansion has exactly one
  5:20 note: the first one is here
)");
}

TEST_CASE("expansions used by no macro-step, by two, or by themselves") {
    CHECK(messages_of(R"(
input a
graph G { initial 1 macro M = e macro N = e macro O = G 1 -> M : a M -> N : a }
expansion e { entry E1 exit S1 E1 -> S1 : a }
expansion f { entry E2 exit S2 E2 -> S2 : a }
expansion g { entry E3 exit S3 macro P = h E3 -> P : a P -> S3 : a }
expansion h { entry E4 exit S4 macro Q = g E4 -> Q : a Q -> S4 : a }
expansion k { entry E5 exit S5 macro R = k E5 -> R : a R -> S5 : a }
)") == R"(3:43 error: expansion 'e' expands macro-step 'M' already; each macro-step needs an expansion of its own
  3:27 note: it is first used here
3:55 error: 'G' is a graph; a macro-step is expanded by an expansion, declared with 'expansion G { … }'
5:11 error: no macro-step uses expansion 'f'; declare one with 'macro M = f', or remove the expansion
6:11 error: expansion 'g' contains itself ('g' → 'h' → 'g'); a macro-step must not lead back to an expansion it stands in
8:11 error: expansion 'k' contains itself ('k' → 'k'); a macro-step must not lead back to an expansion it stands in
)");
}

TEST_CASE("assumptions about more than the plant") {
    CHECK(messages_of(R"(
input a, b
output l
var v
assume /(a . Init)
assume a . v + X1 . l
assume ↑a + 3s/b + [c = 1]
counter c : 0..1
graph G { initial 1 : set l 1 -> 1 : b . [c = 1] do set v }
)") == R"(6:12 error: 'v' is no input in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
6:16 error: 'X1' is no input in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
6:21 error: 'l' is no input in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
7:8 error: edge in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
7:13 error: time condition in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
7:20 error: comparison in 'assume'; an assumption is about the plant, so it is made of inputs and control inputs, without edges, times and comparisons
)");
}

TEST_CASE("assumptions that exclude each other, those that do") {
    const std::string head = "input a, b, c, d\nassume /(c . d)\n";
    const std::string tail = "\ngraph G { initial 1 1 -> 1 : a.b.c.d }\n";
    CHECK(messages_of(head + "assume a ⊕ b\nassume b ⊕ c\nassume a ⊕ c" + tail) ==
          R"(5:8 error: this assumption contradicts 2 others together, so that no input is left
  3:8 note: the other: assume a ⊕ b
  4:8 note: the other: assume b ⊕ c
)");
    CHECK(messages_of(head + "assume c.d + Init . /Init . a" + tail) ==
          R"(3:8 error: this assumption contradicts another, so that no input is left
  2:8 note: the other: assume /(c.d)
)");
    CHECK(messages_of(head + "assume a . /a" + tail) ==
          "3:8 error: this assumption is never 1, so that no input is left\n");
    CHECK(messages_of(head + "assume 1 . 0" + tail) ==
          "3:8 error: this assumption is never 1, so that no input is left\n");
    CHECK(messages_of(head + "assume a ⊕ b\nassume b ⊕ c\nassume /(a ⊕ c)" + tail).empty());
}

TEST_CASE("many inputs tied in parity are decided at once") {
    std::string parity = "i0";
    std::string inputs = "input i0";
    for (int i = 1; i < 40; ++i) {
        parity += " ⊕ i" + std::to_string(i);
        inputs += ", i" + std::to_string(i);
    }
    const std::string tail = "\ngraph G { initial 1 1 -> 1 : " + parity + " }\n";
    CHECK(messages_of(inputs + "\nassume " + parity + tail).empty());
    CHECK(messages_of(inputs + "\nassume " + parity + "\nassume /(" + parity + ")" + tail)
              .find("3:8 error: this assumption contradicts another") == 0);
}

TEST_CASE("a file without steps") {
    const std::string why =
        " error: there is no step, and a GRAFCET needs one at least: graph G { initial 0 }\n";
    CHECK(messages_of("") == "1:1" + why);
    CHECK(messages_of("input a # nothing else\ngraph G {}").find("2:7" + why) != std::string::npos);
}

TEST_CASE("durations and numbers out of range") {
    CHECK(messages_of(R"(
input a
counter c : 0..3
graph G {
  initial 1
  1 -> 1 : 2562h/a . 2563h/a . 1s/a/9999999999999s . 0.0000000000001s/a
  1 -> 1 : [c < 1000000000000] + [c < 1000000000001]
}
)") == R"(6:22 error: the duration '2563h' is too long or too fine; durations go up to 106 days in whole picoseconds
6:37 error: the duration '9999999999999s' is too long or too fine; durations go up to 106 days in whole picoseconds
6:54 error: the duration '0.0000000000001s' is too long or too fine; durations go up to 106 days in whole picoseconds
7:39 error: the number '1000000000001' is too large; numbers go up to 1000000000000
)");
}

TEST_CASE("each refusal has its code") {
    const auto with = [](std::string_view rest) {
        return "input a\noutput l\nvar v\ncounter c : 0..3\ngraph G { initial 1 : set l, set v 1 "
               "-> 1 "
               ": a . [c = 0] }\n" +
               std::string(rest);
    };
    const auto graph = [&](std::string_view step, std::string_view receptivity = "a") {
        return with("graph H { initial 2 " + std::string(step) +
                    " 2 -> 2 : " + std::string(receptivity) + " }");
    };
    CHECK(messages_of(graph("")).empty());
    CHECK(gives_only(graph("", "b"), code::unknown_name));
    CHECK(gives_only(graph("", "l . "), code::unexpected_token));
    CHECK(gives_only(graph("", "l §"), code::unexpected_character));
    CHECK(gives_only("grafcet g \"title\n", code::unterminated_text));
    CHECK(gives_only("counter c : 0..9999999999999", code::number_too_large));
    CHECK(gives_only(graph("", "[c = 9999999999999]"), code::number_too_large));
    CHECK(gives_only(graph("", "9999h/a"), code::duration_out_of_range));
    CHECK(gives_only(graph("", std::string(600, '/') + "a"), code::nested_too_deep));
    CHECK(gives_only(with("graph G { }"), code::duplicate_name));
    CHECK(
        gives_only(with("graph H { initial 2 -> : a 2 -> 2 : a }"), code::transition_without_step));
    CHECK(gives_only(graph("1 -> 2 : a"), code::step_of_another_graph));
    CHECK(gives_only(graph(": set a"), code::assignment_to_input));
    CHECK(gives_only(graph(": c"), code::continuous_on_internal));
    CHECK(gives_only("input a output l graph G { initial 1 : l if ↑a 1 -> 1 : a }",
                     code::edge_in_condition));
    CHECK(gives_only(
        "input a graph G { initial 1 macro M = e 1 -> M : a M -> 1 : a }\n"
        "expansion e { entry E exit S E -> S : a } graph H { initial 9 : G{M} 9 -> 9 : a }",
        code::macro_not_allowed_here));
    CHECK(gives_only("input a output l graph G { initial 1 : l 1 -> 1 : a . l }",
                     code::reads_continuous_output));
    CHECK(gives_only(graph(": l"), code::output_driven_twice));
    CHECK(gives_only(graph(": K{}"), code::forcing_unknown_graph));
    CHECK(gives_only(graph(": K{*}"), code::forcing_unknown_graph));
    CHECK(gives_only(graph(": G{2}"), code::forcing_foreign_step));
    CHECK(gives_only(graph(": H{2}"), code::forcing_circle));
    CHECK(gives_only("counter d : 3..2", code::counter_range));
    CHECK(gives_only(graph("", "[a = 1]"), code::not_a_counter));
    CHECK(gives_only(graph("", "c"), code::not_a_boolean));
    CHECK(gives_only(
        graph("encloses K{4} initial 3 encloses K{4}") + "graph K { initial 4 4 -> 4 : a }",
        code::enclosed_twice));
    CHECK(gives_only(graph("encloses L{5} encloses K{4}") + "graph K { initial 4 4 -> 4 : a }" +
                         "graph L { initial 5 5 -> 5 : a }",
                     code::encloses_twice));
    CHECK(gives_only(graph("encloses K{4}") + "graph K { step 4 4 -> 4 : a }",
                     code::enclosure_initial_mismatch));
    CHECK(gives_only(graph("step G"), code::variable_clash));
    CHECK(gives_only(with("expansion e { entry E exit S E -> S : a }"), code::expansion_use));
    CHECK(
        gives_only("input a graph G { initial 1 macro M = e 1 -> M : a M -> 1 : a }\n"
                   "expansion e { entry E }",
                   code::expansion_entry_exit));
    CHECK(gives_only("assume ↑Init", code::not_a_plant_condition));
    CHECK(gives_only("input a # \xe9", code::not_utf8));
}

TEST_CASE("refusals in French") {
    const SourceFile source{"test", R"(
input start
output lamp
graph G {
  initial 1 : lampe
  step 2 : G{1}
  1 -> 2 : start . )
  2 -> 1 : start
}
graph "H 1" { step 2 2 -> 1 : 1 }
)"};
    Diagnostics diagnostics;
    CHECK_FALSE(parse_grafcet(source, diagnostics));
    std::string shown;
    for (const Diagnostic& item : diagnostics.items()) {
        shown += item.message.french + "\n";
        for (const Diagnostic::Note& note : item.notes) shown += "  " + note.message.french + "\n";
    }
    CHECK(shown ==
          R"(la sortie « lampe » est inconnue ; vouliez-vous dire « lamp » ?
l'étape « 2 » force son propre grafcet partiel « G » ; on ne peut forcer ou encapsuler qu'un autre grafcet partiel
on attend ici une condition et non « ) »
l'étape « 2 » existe déjà ; un nom d'étape est unique dans tout le fichier, renommez donc l'une des deux
  la première déclaration est ici
l'étape « 1 » est dans le grafcet partiel « G » ; une transition placée dans le grafcet partiel « H 1 » ne nomme que des étapes et des macro-étapes de ce grafcet partiel
  la déclaration est ici : l'étape « 1 »
)");
    CHECK(format_diagnostics(diagnostics, source, Language::french)
              .starts_with("test:5:15: erreur\u00a0: la sortie « lampe » est inconnue"));
}
