// The canonical layout: each rule of it by a small chart.

#include "grafcet/describe_grafcet.h"
#include "grafcet/format_grafcet.h"
#include "parsing.h"
#include "properties/same_model.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string formatted(std::string_view text, Language language = Language::english) {
    Diagnostics diagnostics;
    const auto laid_out = format_grafcet({"test", std::string(text)}, language, diagnostics);
    REQUIRE_MESSAGE(laid_out.has_value(), messages_of(diagnostics));
    return *laid_out;
}

/// What is written for a text is the same chart, and stays as it is.
std::string checked(std::string_view text, Language language = Language::english) {
    const std::string result = formatted(text, language);
    CHECK(model_difference(parsed(text), parsed(result)) == "");
    CHECK(write_grafcet(parsed(text)) == write_grafcet(parsed(result)));
    CHECK(formatted(result, language) == result);
    const Language other = language == Language::english ? Language::french : Language::english;
    CHECK(formatted(formatted(result, other), language) == result);
    return result;
}

/// A line of the layout of a graph with this part in it.
std::string part(std::string_view text, Language language = Language::english) {
    const std::string before =
        "input a, b, \"c d\"\noutput V, H\nvar m\ncounter n : 0..9\ntime T = 3s\ngraph G {\n"
        "  initial 0 : V\n  step 1 : H, set m\n  0 -> 1 : a\n\n";
    const std::string result =
        checked(before + std::string(text) + "\n\n1 -> 0 : [n = 1]\n}\n", language);
    const std::size_t begin = result.find("\n\n") + 2;
    return result.substr(begin, result.rfind("\n\n  1 ") - begin);
}

/// The layout of a condition.
std::string condition(std::string_view text) {
    const std::string line = part("(t) 0 -> 1 : " + std::string(text));
    return line.substr(line.find(": ") + 2);
}

}  // namespace

TEST_CASE("a text that is crowded or torn apart is laid out") {
    CHECK(
        checked(
            "\xef\xbb\xbfgrafcet g \"A title\"input a,b output V graph G{initial step 0:V step 1\n"
            "(t)0->1:a.b 1->0:=1}") == R"(grafcet g "A title"
input a, b
output V
graph G {
  initial 0 : V
  step 1
  (t) 0 -> 1 : a . b
  1     -> 0 : =1
}
)");
    CHECK(checked("\r\n\r\ngraph\r\nG\r\n{\r\n\r\n\tinitial\r\n0\t\r\n\r\n\r\n\r\n-> \r\n 0 :\r\n"
                  "Init\r\n\r\n}\r\n\r\n") == R"(graph G {
  initial 0

  -> 0 : Init
}
)");
    CHECK(checked("graph G { initial 0 0 -> 0 : Init } graph H { }") ==
          "graph G {\n  initial 0\n  0 -> 0 : Init\n}\ngraph H {\n}\n");
}

TEST_CASE("columns of steps, transitions, counters and comments") {
    CHECK(checked(R"(counter n : 0..5 # pieces
counter boxes : -3..2 # full
time T1 = 3s
time long = 5min
define ready = a . b
define go = 1
input a, b, m
output V, H

graph G {
  initial 0 : V
  step 1 : H
  step 2

  (0) -> 1 : a
  (1) 1 -> 2 : =1
  (22) 2, 1 -> : b # a sink
  (3) 2 -> 0, 1 : m
}
)") == R"(counter n     : 0..5   # pieces
counter boxes : -3..2  # full
time T1   = 3s
time long = 5min
define ready = a . b
define go    = 1
input a, b, m
output V, H

graph G {
  initial 0 : V
  step 1    : H
  step 2

  (0)       -> 1    : a
  (1)  1    -> 2    : =1
  (22) 2, 1 ->      : b  # a sink
  (3)  2    -> 0, 1 : m
}
)");
}

TEST_CASE("a blank line ends a group, a comment does not, and what is too wide stands for itself") {
    CHECK(checked(R"(input a
output V
graph G {
  initial 10 : V # x
  # of the same group
  step 2 : V if a # y

  step 3 : V
  step "a name of more than twenty" : V
  step 44 : V # z
  step 5 : V if a . /a . a . /a . a . /a . a . /a . a . /a . a . /a . a . /a # w
}
)") == R"(input a
output V
graph G {
  initial 10 : V       # x
  # of the same group
  step 2     : V if a  # y

  step 3  : V
  step "a name of more than twenty" : V
  step 44 : V  # z
  step 5  : V if a . /a . a . /a . a . /a . a . /a . a . /a . a . /a . a . /a  # w
}
)");
}

TEST_CASE("labels have a column where each transition has one") {
    CHECK(part("0 -> 1 : a\n(full) 0 -> 1 : b") == "  0        -> 1 : a\n  (full) 0 -> 1 : b");
    CHECK(part("(b)0 -> 1 : a\n(full) 0 -> 1 : b") == "  (b)    0 -> 1 : a\n  (full) 0 -> 1 : b");
}

TEST_CASE("comments stand where they stood") {
    CHECK(checked(R"(#!first
   # second


# third
input a #   of the plant
    , #
b
# before the graph
graph G # the graph
{ # opened

  # before the step
initial 0 # behind the step


     # before the transition
  (t) # behind the label
  0 # behind the step before
  -> 0 # behind the step after
  : # behind the colon
  a # behind a
  # below a
  + b
  # at the end of the graph

} # closed
# the end

# really)") == R"(#!first
# second

# third
input a  #   of the plant
      ,  #
      b
# before the graph
graph G  # the graph
      {  # opened
  # before the step
  initial 0  # behind the step

  # before the transition
  (t)       # behind the label
      0     # behind the step before
      -> 0  # behind the step after
      :     # behind the colon
      a     # behind a
      # below a
      + b
  # at the end of the graph
}  # closed
# the end

# really
)");
}

TEST_CASE("line ends stay behind commas, around operators and before do") {
    CHECK(part("step 2 : V,\n H if a . b +\n a\nstep 3 : set m on a\n. b") ==
          "  step 2 : V,\n           H if a . b +\n           a\n  step 3 : set m on a\n"
          "           . b");
    CHECK(part("(t) 0,\n1 -> \n 0,\n1 :\na\ndo\nset\nm,\nn\n:=\nn\n+\n1") ==
          "  (t) 0, 1 -> 0, 1 : a\n                     do set m,\n                     n := n\n"
          "                     +\n                     1");
    CHECK(
        checked("input a,\nb\n,\nc\nassume\n/(a\n.b)\ngraph G { initial 0 0 -> 0 : a . b . c }") ==
        "input a,\n      b,\n      c\nassume /(a\n       . b)\n"
        "graph G {\n  initial 0\n  0 -> 0 : a . b . c\n}\n");
}

TEST_CASE("one spelling of each operator") {
    CHECK(condition("a*b&a·b∧a and b et a") == "a . b . a . b . a . b . a");
    CHECK(condition("a|b∨a or b ou a+b") == "a + b + a + b + a + b");
    CHECK(condition("a xor b⊕a") == "a ⊕ b ⊕ a");
    CHECK(condition("!a.¬b.not a.non b./ a.//b") == "/a . /b . /a . /b . /a . //b");
    CHECK(condition("rise(a) + fall( b ) + rise(a+b) + ↑ a + rise(((a)))") ==
          "↑a + ↓b + ↑(a + b) + ↑a + ↑(((a)))");
    CHECK(condition("rise(a\u0305) + fall(a)\u0305") == "↑/a + ↓/(a)");
    CHECK(condition("a\u0305 + (a + \"c d\")\u0305 . b\u0305") == "/a + /(a + \"c d\") . /b");
    CHECK(condition("1s / a\u0305 / 2s + ( 3s/(a)\u0305 )") == "1s//a/2s + (3s//(a))");
    CHECK(condition("T / a / T + 1.50s/X0") == "T/a/T + 1.50s/X0");
    CHECK(condition("[ n+1>=-n-3 ].[n≤3].[n≠3].[n≥3]") ==
          "[n + 1 >= -n - 3] . [n <= 3] . [n <> 3] . [n >= 3]");
    CHECK(condition("( ( a ) )do n:=-n-1,set m,m:=a.b") ==
          "((a)) do n := -n - 1, set m, m := a . b");
    CHECK(part("0→1:a") == "  0 -> 1 : a");
    CHECK(part("0->1:=a") == "  0 -> 1 : =a");
    CHECK(part("0->1: = a") == "  0 -> 1 : =a");
}

TEST_CASE("steps, orders, enclosures and macro-steps") {
    CHECK(checked(R"(graph G{initial step 0 encloses H{10 ,11}:K{ },K{ 20,21 },K{ * },K{INIT}
macro   M=e 0->M:Init M->0:=1}graph H{initial 10 initial 11}graph K{step 20 step 21}
expansion e{entry E exit   S E->S:Init})") == R"(graph G {
  initial 0 encloses H{10, 11} : K{}, K{20, 21}, K{*}, K{INIT}
  macro M = e
  0 -> M : Init
  M -> 0 : =1
}
graph H {
  initial 10
  initial 11
}
graph K {
  step 20
  step 21
}
expansion e {
  entry E
  exit S
  E -> S : Init
}
)");
}

TEST_CASE("names are in normal form and quoted only where they must be") {
    CHECK(checked(
              "grafcet \"g\" \"\"\ninput \"a\", \"b c\", \"5\", \"input\", \"si\", e\u0301t\ngraph "
              "\"7\" { initial \"0\" : \"K\"{\"12\", \"INIT\"} (\"3\") \"0\" -> \"0\" : \"a\" . "
              "\"5\" + \"input\" . \"si\" . \"b c\" . ét }\ngraph K { step 12 step INIT }") ==
          "grafcet g \"\"\ninput a, \"b c\", \"5\", \"input\", \"si\", ét\ngraph 7 {\n"
          "  initial 0 : K{12, \"INIT\"}\n"
          "  (3) 0 -> 0 : a . \"5\" + \"input\" . \"si\" . \"b c\" . ét\n}\n"
          "graph K {\n  step 12\n  step INIT\n}\n");
    // A title is no name.
    CHECK(formatted("grafcet g \"e\u0301\" graph G { initial 0 }") ==
          "grafcet g \"e\u0301\"\ngraph G {\n  initial 0\n}\n");
    // Without the quotation marks the line over the a would be a NOT.
    CHECK(checked("input \"a\u0305\" graph G { initial 0 0 -> 0 : \"a\u0305\" }") ==
          "input \"a\u0305\"\ngraph G {\n  initial 0\n  0 -> 0 : \"a\u0305\"\n}\n");
}

TEST_CASE("keywords in either language") {
    const std::string english = R"(grafcet g
input a
output V
var m, held
counter n : 0..9
assume a
time T       = 3s
define ready = T/X1
graph G {
  initial 0 encloses H{5} : V if ready, set m on deactivation
  step 1 : held, reset m on activation, n := n + 1 on ↑a
  macro M = e
  0 -> 1 : a do set m
  1 -> M : held . m
  M -> 0 : [n = 3]
}
graph H {
  initial 5
}
expansion e {
  entry E
  exit S
  E -> S : =1
}
)";
    const std::string french = R"(grafcet g
entrée a
sortie V
variable m, held
compteur n : 0..9
suppose a
durée T       = 3s
définir ready = T/X1
graphe G {
  étape initiale 0 englobe H{5} : V si ready, set m sur désactivation
  étape 1 : held, reset m sur activation, n := n + 1 sur ↑a
  macro M = e
  0 -> 1 : a faire set m
  1 -> M : held . m
  M -> 0 : [n = 3]
}
graphe H {
  étape initiale 5
}
expansion e {
  début E
  fin S
  E -> S : =1
}
)";
    CHECK(checked(french, Language::french) == formatted(english, Language::french));
    CHECK(checked(french, Language::english) == formatted(english, Language::english));
    const auto unaligned = [](std::string text) {
        for (std::size_t at = text.find("       = "); at != text.npos;
             at = text.find("       = ")) {
            text.erase(at, 6);
        }
        return text;
    };
    CHECK(unaligned(formatted(english)) == unaligned(english));
    CHECK(unaligned(formatted(english, Language::french)) == unaligned(french));
    CHECK(part("ETAPE INITIALE 2 : V SI a", Language::french) == "  étape initiale 2 : V si a");
}

TEST_CASE("a keyword that is the name of a variable stays English") {
    CHECK(checked("input étape, si output V graph G { initial 0 : V if si step 1 0 -> 1 : étape }",
                  Language::french) ==
          "entrée étape, si\nsortie V\ngraphe G {\n  initial 0 : V if si\n  step 1\n"
          "  0 -> 1 : étape\n}\n");
    // At the beginning of a line it would be a step before the arrow below.
    CHECK(checked("var m graph G { initial 0 : set m on # when it ends\ndeactivation -> 0 : Init }",
                  Language::french) ==
          "variable m\ngraphe G {\n  étape initiale 0 : set m sur  # when it ends\n"
          "                     deactivation\n  -> 0 : Init\n}\n");
    // Steps may have the names of keywords, which are quoted where they would be taken for one.
    CHECK(checked("graph G { initial step étape initial initiale step fin 0 -> fin : Init "
                  "fin -> étape, initiale : 1 step 0 }") ==
          "graph G {\n  initial \"étape\"\n  initial \"initiale\"\n  step fin\n  0   -> fin"
          "             : Init\n  fin -> étape, initiale : 1\n  step 0\n}\n");
}

TEST_CASE("a chart with an error is refused as it is read") {
    const SourceFile source{"test", "input a\ngraph G {\n  initial 0\n  0 -> 1 : b\n}\n"};
    Diagnostics of_format;
    Diagnostics of_parser;
    CHECK_FALSE(format_grafcet(source, Language::english, of_format).has_value());
    CHECK_FALSE(parse_grafcet(source, of_parser).has_value());
    CHECK(messages_of(of_format) == messages_of(of_parser));
    Diagnostics of_bytes;
    CHECK_FALSE(format_grafcet({"test", "\xff"}, Language::english, of_bytes).has_value());
    CHECK(of_bytes.has_errors());
}

TEST_CASE(
    "an overline over a duration or a counter is refused, and what is deeply nested stays so") {
    CHECK(gives_only("time T = 1s\ngraph G { initial 0 0 -> 0 : T\u0305/X0 }",
                     code::unexpected_token));
    CHECK(gives_only("counter n : 0..9\ngraph G { initial 0 0 -> 0 : [n\u0305 = 1] }",
                     code::unexpected_token));
    std::string open;
    std::string close;
    for (int i = 0; i < 249; ++i) {
        open += i % 2 == 0 ? "rise((a + " : "(a . ";
        close = (i % 2 == 0 ? "))" : ")\u0305") + close;
    }
    checked("input a\ngraph G { initial 0 0 -> 0 : " + open + "a" + close + " }");
}

TEST_CASE("charts of the language's description keep their layout") {
    CHECK(formatted(R"(graph G {
  initial 0 : H{}    # forcing order: empty
  step 1    : H{10}  # exactly step 10
  step 2
  step 3    : H{*}   # freezing order

  (0) 0 -> 1 : Init
}

graph H {
  initial 10
}
)") == R"(graph G {
  initial 0 : H{}    # forcing order: empty
  step 1    : H{10}  # exactly step 10
  step 2
  step 3    : H{*}   # freezing order

  (0) 0 -> 1 : Init
}

graph H {
  initial 10
}
)");
}
