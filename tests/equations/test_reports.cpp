// The report of one chart with something of everything, in each form, to the byte.

#include <nlohmann/json.hpp>

#include "equations/parsed.h"

namespace grafwire::testing {

namespace {

constexpr std::string_view lamp = R"(
grafcet lamp "Lampe & co"
input m, off, "H|+"
output A, "L_1"
counter n : 0..9
graph G {
  initial 0
  step 1 : A if m + /off, set "L_1"
  step wait : reset "L_1" on deactivation
  0 -> 1 : ↑m . [n < 9] do n := n + 1
  1 -> wait : "H|+" . m + /m . "H|+"
  wait -> 0 : 1.5s/Xwait/20ms
}
)";

constexpr std::string_view two_steps = R"(
input m, b
graph G { initial 0 step 1  0 -> 1 : m.b + m./b  1 -> 0 : b }
)";

std::string report(std::string_view chart, const EquationReport& report,
                   const EquationOptions& options = with_modes) {
    const Grafcet grafcet = parsed(chart);
    return write_equations(grafcet, equations_from(grafcet, options), report);
}

}  // namespace

TEST_CASE("the report in text") {
    CHECK(report(lamp, {.format = EquationFormat::text}) == R"report(Equations of lamp (Lampe & co)
CDX from the steps that follow (successor form), with Init, AUdur and AUdoux.

Activation and deactivation conditions
  Step   CAX                             CDX
  X0     Xwait . 1.5s/Xwait/20ms + Init  X1./Init
  X1     X0.↑m.[n < 9]./Init             Xwait + Init
  Xwait  X1.("H|+".m + /m."H|+")./Init   X0 + Init

Equations of the steps
  X0 = (Xwait . 1.5s/Xwait/20ms + /X1.X0 + Init)./AUdur
  X1 = (X0.↑m.[n < 9] + /Xwait.X1)./Init./AUdur
  Xwait = (X1.("H|+".m + /m."H|+") + /X0.Xwait)./Init./AUdur

Outputs
  A = X1.(m + /off)./AUdoux

Stored outputs and variables
  Variable  Set  Reset
  L_1       ↑X1  ↓Xwait./↑X1

  L_1 = ↑X1 + /(↓Xwait./↑X1).L_1

Counters
  Counter  Range  When                 Write
  n        0..9   X0.↑m.[n < 9]./Init  n := n + 1

Time conditions
  Time condition   Operand  1 after  0 after
  1.5s/Xwait/20ms  Xwait    1.5s     20ms

Edges
  Edge  Operand
  ↑m    m
)report");
}

TEST_CASE("the report in markdown") {
    CHECK(report(lamp, {.format = EquationFormat::markdown}) ==
          R"report(# Equations of lamp (Lampe \& co)

CDX from the steps that follow (successor form), with Init, AUdur and AUdoux.

## Activation and deactivation conditions

| Step | CAX | CDX |
|---|---|---|
| `X0` | `Xwait . 1.5s/Xwait/20ms + Init` | `X1./Init` |
| `X1` | `X0.↑m.[n < 9]./Init` | `Xwait + Init` |
| `Xwait` | `X1.("H\|+".m + /m."H\|+")./Init` | `X0 + Init` |

## Equations of the steps

- `X0 = (Xwait . 1.5s/Xwait/20ms + /X1.X0 + Init)./AUdur`
- `X1 = (X0.↑m.[n < 9] + /Xwait.X1)./Init./AUdur`
- `Xwait = (X1.("H|+".m + /m."H|+") + /X0.Xwait)./Init./AUdur`

## Outputs

- `A = X1.(m + /off)./AUdoux`

## Stored outputs and variables

| Variable | Set | Reset |
|---|---|---|
| `L_1` | `↑X1` | `↓Xwait./↑X1` |

- `L_1 = ↑X1 + /(↓Xwait./↑X1).L_1`

## Counters

| Counter | Range | When | Write |
|---|---|---|---|
| `n` | 0..9 | `X0.↑m.[n < 9]./Init` | `n := n + 1` |

## Time conditions

| Time condition | Operand | 1 after | 0 after |
|---|---|---|---|
| `1.5s/Xwait/20ms` | `Xwait` | 1.5s | 20ms |

## Edges

| Edge | Operand |
|---|---|
| `↑m` | `m` |
)report");
}

TEST_CASE("the report in LaTeX") {
    CHECK(report(lamp, {.format = EquationFormat::latex}) == R"report(% \usepackage{amsmath}
\section*{Equations of lamp (Lampe \& co)}

CDX from the steps that follow (successor form), with Init, AUdur and AUdoux.

\subsection*{Activation and deactivation conditions}

\begin{tabular}{lll}
Step & CAX & CDX \\
\hline
$X_{0}$ & $X_{\mathrm{wait}} \cdot 1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms} + \mathrm{Init}$ & $X_{1} \cdot \overline{\mathrm{Init}}$ \\
$X_{1}$ & $X_{0} \cdot \uparrow m \cdot [n < 9] \cdot \overline{\mathrm{Init}}$ & $X_{\mathrm{wait}} + \mathrm{Init}$ \\
$X_{\mathrm{wait}}$ & $X_{1} \cdot (\text{H\textbar{}+} \cdot m + \overline{m} \cdot \text{H\textbar{}+}) \cdot \overline{\mathrm{Init}}$ & $X_{0} + \mathrm{Init}$ \\
\end{tabular}

\subsection*{Equations of the steps}

\begin{align*}
X_{0} &= (X_{\mathrm{wait}} \cdot 1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms} + \overline{X_{1}} \cdot X_{0} + \mathrm{Init}) \cdot \overline{\mathrm{AUdur}} \\
X_{1} &= (X_{0} \cdot \uparrow m \cdot [n < 9] + \overline{X_{\mathrm{wait}}} \cdot X_{1}) \cdot \overline{\mathrm{Init}} \cdot \overline{\mathrm{AUdur}} \\
X_{\mathrm{wait}} &= (X_{1} \cdot (\text{H\textbar{}+} \cdot m + \overline{m} \cdot \text{H\textbar{}+}) + \overline{X_{0}} \cdot X_{\mathrm{wait}}) \cdot \overline{\mathrm{Init}} \cdot \overline{\mathrm{AUdur}}
\end{align*}

\subsection*{Outputs}

\begin{align*}
A &= X_{1} \cdot (m + \overline{\mathrm{off}}) \cdot \overline{\mathrm{AUdoux}}
\end{align*}

\subsection*{Stored outputs and variables}

\begin{tabular}{lll}
Variable & Set & Reset \\
\hline
$\mathrm{L\_1}$ & $\uparrow X_{1}$ & $\downarrow X_{\mathrm{wait}} \cdot \overline{\uparrow X_{1}}$ \\
\end{tabular}

\begin{align*}
\mathrm{L\_1} &= \uparrow X_{1} + \overline{\downarrow X_{\mathrm{wait}} \cdot \overline{\uparrow X_{1}}} \cdot \mathrm{L\_1}
\end{align*}

\subsection*{Counters}

\begin{tabular}{llll}
Counter & Range & When & Write \\
\hline
$n$ & 0..9 & $X_{0} \cdot \uparrow m \cdot [n < 9] \cdot \overline{\mathrm{Init}}$ & $n := n + 1$ \\
\end{tabular}

\subsection*{Time conditions}

\begin{tabular}{llll}
Time condition & Operand & 1 after & 0 after \\
\hline
$1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms}$ & $X_{\mathrm{wait}}$ & 1.5s & 20ms \\
\end{tabular}

\subsection*{Edges}

\begin{tabular}{ll}
Edge & Operand \\
\hline
$\uparrow m$ & $m$ \\
\end{tabular}
)report");
}

TEST_CASE("the report in CSV") {
    CHECK(report(lamp, {.format = EquationFormat::csv}) == R"report(variable,CAX,CDX,X
X0,Xwait . 1.5s/Xwait/20ms + Init,X1./Init,(Xwait . 1.5s/Xwait/20ms + /X1.X0 + Init)./AUdur
X1,X0.↑m.[n < 9]./Init,Xwait + Init,(X0.↑m.[n < 9] + /Xwait.X1)./Init./AUdur
Xwait,"X1.(""H|+"".m + /m.""H|+"")./Init",X0 + Init,"(X1.(""H|+"".m + /m.""H|+"") + /X0.Xwait)./Init./AUdur"
A,,,X1.(m + /off)./AUdoux
L_1,,,↑X1 + /(↓Xwait./↑X1).L_1
)report");
}

TEST_CASE("the report in JSON") {
    CHECK(report(lamp, {.format = EquationFormat::json}) == R"report({
  "name": "lamp",
  "title": "Lampe & co",
  "options": {"cdx":"successor","modes":true},
  "steps": [
    {"name":"X0","initial":true,"cax":"Xwait . 1.5s/Xwait/20ms + Init","cdx":"X1./Init","x":"(Xwait . 1.5s/Xwait/20ms + /X1.X0 + Init)./AUdur"},
    {"name":"X1","initial":false,"cax":"X0.↑m.[n < 9]./Init","cdx":"Xwait + Init","x":"(X0.↑m.[n < 9] + /Xwait.X1)./Init./AUdur"},
    {"name":"Xwait","initial":false,"cax":"X1.(\"H|+\".m + /m.\"H|+\")./Init","cdx":"X0 + Init","x":"(X1.(\"H|+\".m + /m.\"H|+\") + /X0.Xwait)./Init./AUdur"}
  ],
  "outputs": [
    {"name":"A","equation":"X1.(m + /off)./AUdoux"}
  ],
  "stored": [
    {"name":"L_1","kind":"output","set":"↑X1","reset":"↓Xwait./↑X1","equation":"↑X1 + /(↓Xwait./↑X1).L_1","writes":[{"cause":"deactivation","trigger":"↓Xwait","value":"0"},{"cause":"activation","trigger":"↑X1","value":"1"}]},
    {"name":"n","kind":"counter","low":0,"high":9,"writes":[{"cause":"clearing","trigger":"X0.↑m.[n < 9]./Init","value":"n + 1"}]}
  ],
  "timeConditions": [
    {"condition":"1.5s/Xwait/20ms","operand":"Xwait","onDelay":"1.5s","offDelay":"20ms"}
  ],
  "edges": [
    {"edge":"↑m","operand":"m"}
  ]
}
)report");
}

TEST_CASE("the report in French, with truth tables and Karnaugh maps") {
    CHECK(report(two_steps, {.karnaugh = true, .language = Language::french},
                 {.cdx = CdxForm::transition, .modes = false}) == R"report(Équations de grafcet
CDX d'après les transitions franchies (forme transition), sans Init, AUdur ni AUdoux.

Conditions d'activation et de désactivation
  Étape  CAX              CDX
  X0     X1.b             X0.(m.b + m./b)
  X1     X0.(m.b + m./b)  X1.b

Équations des étapes
  X0 = X1.b + /(X0.(m.b + m./b)).X0
  X1 = X0.(m.b + m./b) + /(X1.b).X1

Table de vérité et tableau de Karnaugh de X0
  X0(t)  CAX0  CDX0  X0(t+dt)  Remarque
  0      0     0     0         L'étape reste inactive (effet mémoire)
  0      0     1     0         L'étape reste inactive
  0      1     0     1         Activation de l'étape
  0      1     1     1         Activation ET désactivation = activation
  1      0     0     1         L'étape reste active (effet mémoire)
  1      0     1     0         Désactivation de l'étape
  1      1     0     1         L'étape reste active
  1      1     1     1         Activation ET désactivation = activation

  X0  00   01  11   10
  0   0    0   1 a  1 a
  1   1 b  0   1 a  1 ab

  Groupe  Produit   Cases (X, CAX CDX)
  a       CAX0      0, 11; 0, 10; 1, 11; 1, 10
  b       /CDX0.X0  1, 00; 1, 10

  X0 = CAX0 + /CDX0.X0

Formes réduites :
  CDX0 = X0.m
  X0 = X1.b + /m.X0

Table de vérité et tableau de Karnaugh de X1
  X1(t)  CAX1  CDX1  X1(t+dt)  Remarque
  0      0     0     0         L'étape reste inactive (effet mémoire)
  0      0     1     0         L'étape reste inactive
  0      1     0     1         Activation de l'étape
  0      1     1     1         Activation ET désactivation = activation
  1      0     0     1         L'étape reste active (effet mémoire)
  1      0     1     0         Désactivation de l'étape
  1      1     0     1         L'étape reste active
  1      1     1     1         Activation ET désactivation = activation

  X1  00   01  11   10
  0   0    0   1 a  1 a
  1   1 b  0   1 a  1 ab

  Groupe  Produit   Cases (X, CAX CDX)
  a       CAX1      0, 11; 0, 10; 1, 11; 1, 10
  b       /CDX1.X1  1, 00; 1, 10

  X1 = CAX1 + /CDX1.X1

Formes réduites :
  CAX1 = X0.m
  X1 = X0.m + /b.X1
)report");
}

TEST_CASE("truth table and Karnaugh map in English") {
    const std::string text = report(two_steps, {.karnaugh = true});
    CHECK(text.substr(text.find("\nTruth table and Karnaugh map of X1\n")) == R"report(
Truth table and Karnaugh map of X1
  X1(t)  CAX1  CDX1  X1(t+dt)  Remark
  0      0     0     0         The step stays inactive (memory effect)
  0      0     1     0         The step stays inactive
  0      1     0     1         Activation of the step
  0      1     1     1         Activation AND deactivation = activation
  1      0     0     1         The step stays active (memory effect)
  1      0     1     0         Deactivation of the step
  1      1     0     1         The step stays active
  1      1     1     1         Activation AND deactivation = activation

  X1  00   01  11   10
  0   0    0   1 a  1 a
  1   1 b  0   1 a  1 ab

  Group  Product   Cells (X, CAX CDX)
  a      CAX1      0, 11; 0, 10; 1, 11; 1, 10
  b      /CDX1.X1  1, 00; 1, 10

  X1 = CAX1 + /CDX1.X1

Smaller forms:
  CAX1 = X0.m./Init
  X1 = X0.m./Init./AUdur + /X0.X1./Init./AUdur
)report");
}

TEST_CASE("truth table and Karnaugh map in LaTeX") {
    const std::string text =
        report(two_steps, {.format = EquationFormat::latex, .karnaugh = true}, without_modes);
    CHECK(text.substr(text.find("\n\\subsection*{Truth table and Karnaugh map of X1}\n")) ==
          R"report(
\subsection*{Truth table and Karnaugh map of X1}

\begin{tabular}{lllll}
$X_{1}(t)$ & $\mathit{CAX}_{1}$ & $\mathit{CDX}_{1}$ & $X_{1}(t+dt)$ & Remark \\
\hline
0 & 0 & 0 & 0 & The step stays inactive (memory effect) \\
0 & 0 & 1 & 0 & The step stays inactive \\
0 & 1 & 0 & 1 & Activation of the step \\
0 & 1 & 1 & 1 & Activation AND deactivation = activation \\
1 & 0 & 0 & 1 & The step stays active (memory effect) \\
1 & 0 & 1 & 0 & Deactivation of the step \\
1 & 1 & 0 & 1 & The step stays active \\
1 & 1 & 1 & 1 & Activation AND deactivation = activation \\
\end{tabular}

\begin{tabular}{lllll}
$X_{1}$ & 00 & 01 & 11 & 10 \\
\hline
0 & 0 & 0 & 1 a & 1 a \\
1 & 1 b & 0 & 1 a & 1 ab \\
\end{tabular}

\begin{tabular}{lll}
Group & Product & Cells (X, CAX CDX) \\
\hline
a & $\mathit{CAX}_{1}$ & 0, 11; 0, 10; 1, 11; 1, 10 \\
b & $\overline{\mathit{CDX}_{1}} \cdot X_{1}$ & 1, 00; 1, 10 \\
\end{tabular}

\begin{align*}
X_{1} &= \mathit{CAX}_{1} + \overline{\mathit{CDX}_{1}} \cdot X_{1}
\end{align*}

Smaller forms:

\begin{align*}
\mathit{CAX}_{1} &= X_{0} \cdot m \\
X_{1} &= X_{0} \cdot m + \overline{X_{0}} \cdot X_{1}
\end{align*}
)report");
}

TEST_CASE("the machine forms do not depend on the language") {
    for (const EquationFormat format : {EquationFormat::csv, EquationFormat::json})
        CHECK(report(lamp, {.format = format, .language = Language::french}) ==
              report(lamp, {.format = format, .language = Language::english}));
}

TEST_CASE("JSON: minimised forms only on request, orders and enclosures where they are") {
    using Json = nlohmann::json;
    const Json plain = Json::parse(report(two_steps, {.format = EquationFormat::json}));
    CHECK_FALSE(plain["steps"][1].contains("minimised"));
    const Json smaller =
        Json::parse(report(two_steps, {.format = EquationFormat::json, .karnaugh = true}));
    CHECK_FALSE(smaller["steps"][0].contains("minimised"));
    CHECK(smaller["steps"][1]["minimised"] ==
          Json::parse(R"({"cax": "X0.m./Init", "x": "X0.m./Init./AUdur + /X0.X1./Init./AUdur"})"));

    const Json orders = Json::parse(report(R"(
        input a
        graph G1 { initial 1 : G3{61}  step 2   1 -> 2 : a   2 -> 1 : a }
        graph G2 { step 50 encloses G3{60}  initial 51   50 -> 51 : a   51 -> 50 : /a }
        graph G3 { step 60 step 61   60 -> 61 : a   61 -> 60 : /a })",
                                           {.format = EquationFormat::json}));
    const Json& step = orders["steps"];
    CHECK_FALSE(step[0].contains("forcedOff"));
    CHECK_FALSE(step[0].contains("enclosing"));
    CHECK(step[4]["name"] == "X60");
    CHECK(step[4]["forcedOff"] == "X1");
    CHECK_FALSE(step[4].contains("forcedOn"));
    CHECK(step[4]["enclosing"] == "X50");
    CHECK(step[4]["link"] == "↑X50./X1./Init");
    CHECK(step[5]["forcedOn"] == "X1");
    CHECK_FALSE(step[5].contains("link"));
}

TEST_CASE("names that need it are quoted in formulas and escaped in every form") {
    constexpr std::string_view chart = R"(
        input "a`b", "50%", "é"
        output "x,y"
        graph G { initial "my step" : "x,y" if "50%"  step 1
                  "my step" -> 1 : "a`b"   1 -> "my step" : "é" })";
    const auto has = [&](EquationFormat format, const std::string& expected) {
        const std::string text = report(chart, {.format = format}, without_modes);
        INFO(text);
        CHECK(text.find(expected) != std::string::npos);
    };
    has(EquationFormat::text, "  \"Xmy step\"  X1.é              X1\n");
    has(EquationFormat::text, "  \"x,y\" = \"Xmy step\".\"50%\"\n");
    has(EquationFormat::csv, "\nXmy step,X1.é,X1,");
    has(EquationFormat::csv, "\n\"x,y\",,,\"\"\"Xmy step\"\".\"\"50%\"\"\"\n");
    has(EquationFormat::markdown, "| `` \"Xmy step\".\"a`b\" `` |");
    has(EquationFormat::latex, "\\text{x,y} &= X_{\\text{my step}} \\cdot \\text{50\\%}\n");
    has(EquationFormat::latex, "X_{1} \\cdot \\text{é}");
    has(EquationFormat::json, R"("name":"Xmy step")");
}

TEST_CASE("LaTeX: operators, nested negations and time conditions") {
    const std::string text = report(R"(
        input a, b, c
        graph G { initial 0 step 1
                  0 -> 1 : (a ⊕ b).c + /(/(a + b).c).↓(a.b)   1 -> 0 : 2s/(3s/a/1min) . 1s//b })",
                                    {.format = EquationFormat::latex}, without_modes);
    INFO(text);
    CHECK(text.find(R"($X_{0} \cdot ((a \oplus b) \cdot c + \overline{\overline{a + b} \cdot c} )"
                    R"(\cdot \downarrow (a \cdot b))$)") != std::string::npos);
    CHECK(text.find(R"($X_{1} \cdot 2\,\mathrm{s}/(3\,\mathrm{s}/a/1\,\mathrm{min}) )"
                    R"(\cdot 1\,\mathrm{s}/\overline{b}$)") != std::string::npos);
}

TEST_CASE(
    "variables without writes are 0; the columns of a text table stay aligned up to a limit") {
    const std::string text = report(R"(
        input a_rather_long_name_for_an_input, another_rather_long_name
        var idle
        graph G { initial 0 step 1
                  0 -> 1 : a_rather_long_name_for_an_input . another_rather_long_name + idle
                  1 -> 0 : 1 })",
                                    {}, without_modes);
    INFO(text);
    CHECK(
        text.find(
            "  Step  CAX  CDX\n"
            "  X0    X1   X1\n"
            "  X1    X0.(a_rather_long_name_for_an_input.another_rather_long_name + idle)  X0\n") !=
        std::string::npos);
    CHECK(text.find("  idle      0    0\n\n  idle = 0\n") != std::string::npos);
}

}  // namespace grafwire::testing
