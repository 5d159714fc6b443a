// Syntax errors: each is reported where it is, and reading goes on behind it.

#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

TEST_CASE("every part of a file is read although each has an error") {
    CHECK(messages_of(R"(
grafcet demo "title" nonsense
input a, , b
input c
output l m
counter k 0..3
assume a .
graph G {
  initial 1 : l,
  step 2 : l if
  stap 3
  macro M cycle
  step 4 : G{5
  step 6 encloses {7}
  1 -> 2 : a + ) b
  2 -> 1 a
  2 => 1 : a
  (t 1 -> 2 : a
  1 -> 2 : rise a
  2 -> 1 : a do lamp
  2 -> 4 : zzz
}
graph H 
  initial 10
  10 -> 10 : yyy
}
graph {
  initial 11 : set
  11 -> 11 : xxx
)") == R"(2:22 error: expected a declaration or a graph, got 'nonsense'
3:10 error: expected an input, got ','
5:10 error: expected ',' between the names, got 'm'
6:11 error: expected ':' and the range, as in counter c : 0..9, got '0'
7:11 error: expected a condition, got 'graph'
10:3 error: expected an action, got 'step', a reserved word; to use it as a name write "step"
11:3 error: unknown variable 'stap'
12:3 error: expected ',' or '->', got 'macro'
12:11 error: expected '=' and the name of the expansion, got 'cycle'
14:3 error: expected ',' or '}', got 'step'
14:19 error: expected the name of the enclosed graph, got '{'
15:16 error: expected a condition, got ')'
16:10 error: expected ',' or ':' and the transition condition, got 'a'
17:5 error: expected ',' or '->', got '='
18:6 error: expected ')' after the name of the transition, got '1'
19:17 error: expected '(' after 'rise', got 'a'
21:3 error: expected ':=' and the value, got '2'
21:12 error: unknown variable 'zzz'
24:3 error: expected '{' and the steps of the graph, got 'initial'
25:14 error: unknown variable 'yyy'
27:7 error: expected the name of the graph, got '{'
29:3 error: expected the name of an output or var, got '11'; to use it as a name put it between quotation marks
29:14 error: unknown variable 'xxx'
)");
}

TEST_CASE("reserved words, durations and numbers where a name is expected") {
    CHECK(messages_of(R"(
input step, b
input 5
output "on", on
graph G {
  initial if
  step 5s
  step 7 : 8, set 9, reset do
  7 -> 7 : graph . b
}
)") == R"(2:7 error: expected an input, got 'step', a reserved word; to use it as a name write "step"
3:7 error: expected an input, got '5'; to use it as a name put it between quotation marks
4:14 error: expected an output, got 'on', a reserved word; to use it as a name write "on"
6:11 error: expected the name of the step, got 'if', a reserved word; to use it as a name write "if"
7:8 error: expected the name of the step, got '5s'; to use it as a name put it between quotation marks
8:12 error: expected an action, got '8'; an output of that name is written between quotation marks
9:12 error: expected a condition, got 'graph'
9:12 error: expected '}' at the end of graph 'G', got 'graph'
  5:7 note: it begins here
9:18 error: expected the name of the graph, got '.'
)");
}

TEST_CASE("a reserved word is hidden by quotation marks") {
    CHECK(messages_of(R"(
input "step", "if"
graph "graph" { initial "initial" "initial" -> "initial" : "step" . "if" . Xinitial }
)") == R"()");
}

TEST_CASE("parts in the wrong place") {
    CHECK(messages_of(R"(
input a
step 5
graph G {
  initial 1
  input b
  1 -> 1 : a . b
}
}
output l
grafcet late
graph H { initial 2 : l 2 -> 2 : a }
)") == R"(3:1 error: 'step' stands inside a graph or an expansion, as in graph G1 { … }
6:3 error: declarations stand before the graphs; move this 'input' up, or close the graph with '}' before it
9:1 error: this '}' closes nothing; remove it
10:1 error: declarations stand before the graphs; move this 'output' up
11:1 error: 'grafcet' stands once, at the beginning of the file
)");
}

TEST_CASE("a missing closing brace") {
    CHECK(messages_of(R"(
input a
graph G {
  initial 1 : H{*
  1 -> 1 : a
graph H {
  initial 2 : G{
  }
  2 -> 2 : a
}
graph K {
  initial 3 3 -> 3 : a
)") == R"(5:3 error: expected '}', got '1'
6:1 error: expected '}' at the end of graph 'G', got 'graph'
  3:7 note: it begins here
13:1 error: expected '}' at the end of graph 'K', got the end of the file
  11:7 note: it begins here
)");
}

TEST_CASE("characters that belong to no token") {
    CHECK(messages_of(R"(
input a, b-c
graph G {
  initial 1 : a$b
  1 ⇒ 1 : a ∩ b
  1 -> 1 : ﻿a ; b
  1 -> 1 : a  %% é_1
}
)") == R"(2:11 error: expected a declaration or a graph, got '-'
4:15 error: 'a' is an input, which the GRAFCET reads and never writes; name an output, a var or a counter
4:16 error: the character '$' has no meaning here; remove it, or write the name it belongs to between quotation marks
5:3 error: expected ',' or '->', got '1'
5:5 error: the character '⇒' has no meaning here; remove it, or write the name it belongs to between quotation marks
5:13 error: the character '∩' has no meaning here; remove it, or write the name it belongs to between quotation marks
6:12 error: the character U+FEFF has no meaning here; remove it, or write the name it belongs to between quotation marks
6:15 error: the character ';' has no meaning here; remove it, or write the name it belongs to between quotation marks
7:3 error: expected ',' or '->', got '1'
7:14 error: the character U+0001 has no meaning here; remove it, or write the name it belongs to between quotation marks
7:16 error: the character '%' has no meaning here; remove it, or write the name it belongs to between quotation marks
8:1 error: expected ',' or '->', got '}'
)");
}

TEST_CASE("texts without an end") {
    CHECK(messages_of(R"(
grafcet g "no end
input "a
output l
graph G { initial 1 : "l  
  1 -> 1 : "
  "" -> 1 : a
}
)") == R"(2:11 error: this quoted text has no end on its line; close it with '"'
3:7 error: this quoted text has no end on its line; close it with '"'
5:23 error: this quoted text has no end on its line; close it with '"'
5:23 error: unknown output 'l  '
6:12 error: this quoted text has no end on its line; close it with '"'
6:12 error: expected a condition, got an empty name
7:3 error: expected the name of a step, got an empty name
)");
}

TEST_CASE("time conditions that are none") {
    CHECK(messages_of(R"(
input a
graph G {
  initial 1
  1 -> 1 : 5s
  1 -> 1 : 5s.a
  1 -> 1 : 5s/a/b
  1 -> 1 : a/5s
  1 -> 1 : 5 s/a
  1 -> 1 : 2.5
  1 -> 1 : 1s/
}
)") == R"(6:3 error: expected '/' after the duration, as in 5s/X13, got '1'
6:14 error: expected '/' after the duration, as in 5s/X13, got '.'
7:17 error: unknown duration 'b'; declare it with time, as in time T3 = 300ms, or write an operator before it
8:12 error: a time condition is written with the duration first and the variable behind it: 5s/a
9:12 error: no space stands between a number and its unit: 5s, as in 5s/X5
10:12 error: the number '2' is no condition: the variable of step 2 is X2, and counters are compared in brackets, as in [c = 2]
11:15 error: expected a condition, got '}'
)");
}

TEST_CASE("brackets and parentheses") {
    CHECK(messages_of(R"(
input a
counter c : 0..3
graph G {
  initial 1
  1 -> 1 : [c = 1
  1 -> 1 : [c + = 1]
  1 -> 1 : [c 1]
  1 -> 1 : (a + (a)
  1 -> 1 : ()
  1 -> 1 : [c = 1 + a]] 
  1 -> 1 : rise(a
}
)") == R"(7:3 error: expected ']' at the end of the comparison, got '1'
7:17 error: expected a counter or a number, got '='
8:15 error: expected one of = <> < <= > >= in the comparison, got '1'
10:3 error: expected an operator or ')', got '1'
10:13 error: expected a condition, got ')'
11:21 error: 'a' is not a counter; only counters and numbers are compared and added
11:23 error: expected a step, a transition or '}', got ']'
13:1 error: expected an operator or ')', got '}'
)");
}

TEST_CASE("orders and enclosures") {
    CHECK(messages_of(R"(
graph G {
  initial 1 : H{INIT, 2}, H{*}
  step 3 : H{2,}
  step 4 : H{2 2}, K{}
  step 5 encloses H
  step 6 encloses H{}
  step 7 encloses H{INIT}
  step 8 encloses H{*}
  1 -> 3 : 1
}
graph H { initial 2 2 -> 2 : XG }
)") == R"(3:21 error: expected '}', got ','
4:16 error: expected the name of a step, '*', INIT or '}', got '}'
5:16 error: expected ',' or '}', got '2'
7:3 error: expected '{' and the steps to activate, as in G3{60}, got 'step'
7:21 error: an enclosing step names the steps that are activated with it, as in G3{60}
8:21 error: unknown step 'INIT'
9:21 error: expected the name of a step, got '*'
12:19 error: step '2' is initial, but step '7', which encloses its graph 'H', is not; make both initial or neither
  8:8 note: the enclosing step is here
)");
}

TEST_CASE("columns count characters after letters, arrows and tabs") {
    CHECK(messages_of(R"(
input été, 漢字
graph G {
	initial 1
	1 -> 1 : ↑été ⊕ ↓漢字 . 𝄞x . /unknwn
}
)") == R"(5:24 error: unknown variable '𝄞x'
5:30 error: unknown variable 'unknwn'
)");
}
