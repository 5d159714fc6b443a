// The report of one chart with something of everything, in each form, to the byte.

#include <nlohmann/json.hpp>

#include "equations/parsed.h"
#include "text/version.h"

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

Transitions
  Transition  Steps        Transition condition  Clearing condition
  (0)         X0 -> X1     ↑m.[n < 9]            X0.↑m.[n < 9]
  (1)         X1 -> Xwait  "H|+".m + /m."H|+"    X1.("H|+".m + /m."H|+")
  (2)         Xwait -> X0  1.5s/Xwait/20ms       Xwait . 1.5s/Xwait/20ms

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

## Transitions

| Transition | Steps | Transition condition | Clearing condition |
|---|---|---|---|
| (0) | `X0 -> X1` | `↑m.[n < 9]` | `X0.↑m.[n < 9]` |
| (1) | `X1 -> Xwait` | `"H\|+".m + /m."H\|+"` | `X1.("H\|+".m + /m."H\|+")` |
| (2) | `Xwait -> X0` | `1.5s/Xwait/20ms` | `Xwait . 1.5s/Xwait/20ms` |

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
    CHECK(report(lamp, {.format = EquationFormat::latex}) ==
          "% " + program_and_version() + R"report(
% Needs in the preamble: \usepackage{amsmath,array,booktabs,longtable}
\providecommand{\equationlist}[1]{\raggedright
  \settowidth{\labelwidth}{#1}\setlength{\leftmargin}{\labelwidth}%
  \addtolength{\leftmargin}{\labelsep}\setlength{\itemsep}{3pt}\setlength{\parsep}{0pt}}
\section*{\raggedright Equations of lamp (Lampe \& co)}

\noindent CDX from the steps that follow (successor form), with Init, AUdur and AUdoux.

\subsection*{\raggedright Transitions}

\noindent\begin{tabular}{@{}llll@{}}
\toprule
Transition & Steps & Transition condition & Clearing condition \\
\midrule
(0) & $X_{0} \to X_{1}$ & ${\uparrow}m \cdot {[n < 9]}$ & $X_{0} \cdot {\uparrow}m \cdot {[n < 9]}$ \\
(1) & $X_{1} \to X_{\mathrm{wait}}$ & $\text{H\textbar{}+} \cdot m \allowbreak + \overline{m} \cdot \text{H\textbar{}+}$ & $X_{1} \cdot (\text{H\textbar{}+} \cdot m \allowbreak + \overline{m} \cdot \text{H\textbar{}+})$ \\
(2) & $X_{\mathrm{wait}} \to X_{0}$ & $1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms}$ & $X_{\mathrm{wait}} \cdot 1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms}$ \\
\bottomrule
\end{tabular}

\subsection*{\raggedright Activation and deactivation conditions}

\noindent\begin{tabular}{@{}lll@{}}
\toprule
Step & CAX & CDX \\
\midrule
$X_{0}$ & $X_{\mathrm{wait}} \cdot 1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms} \allowbreak + \mathrm{Init}$ & $X_{1} \cdot \overline{\mathrm{Init}}$ \\
$X_{1}$ & $X_{0} \cdot {\uparrow}m \cdot {[n < 9]} \cdot \overline{\mathrm{Init}}$ & $X_{\mathrm{wait}} + \mathrm{Init}$ \\
$X_{\mathrm{wait}}$ & $X_{1} \cdot (\text{H\textbar{}+} \cdot m \allowbreak + \overline{m} \cdot \text{H\textbar{}+}) \cdot \overline{\mathrm{Init}}$ & $X_{0} + \mathrm{Init}$ \\
\bottomrule
\end{tabular}

\subsection*{\raggedright Equations of the steps}

\begin{list}{}{\equationlist{$X_{\mathrm{wait}} =$}}
\item[$X_{0} =$] $(X_{\mathrm{wait}} \cdot 1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms} + \overline{X_{1}} \cdot X_{0} + \mathrm{Init}) \cdot \overline{\mathrm{AUdur}}$
\item[$X_{1} =$] $(X_{0} \cdot {\uparrow}m \cdot {[n < 9]} + \overline{X_{\mathrm{wait}}} \cdot X_{1}) \cdot \overline{\mathrm{Init}} \cdot \overline{\mathrm{AUdur}}$
\item[$X_{\mathrm{wait}} =$] $(X_{1} \cdot (\text{H\textbar{}+} \cdot m + \overline{m} \cdot \text{H\textbar{}+}) \allowbreak + \overline{X_{0}} \cdot X_{\mathrm{wait}}) \cdot \overline{\mathrm{Init}} \cdot \overline{\mathrm{AUdur}}$
\end{list}

\subsection*{\raggedright Outputs}

\begin{list}{}{\equationlist{$A =$}}
\item[$A =$] $X_{1} \cdot (m + \overline{\mathrm{off}}) \cdot \overline{\mathrm{AUdoux}}$
\end{list}

\subsection*{\raggedright Stored outputs and variables}

\noindent\begin{tabular}{@{}lll@{}}
\toprule
Variable & Set & Reset \\
\midrule
$\mathrm{L\_1}$ & ${\uparrow}X_{1}$ & ${\downarrow}X_{\mathrm{wait}} \cdot \overline{{\uparrow}X_{1}}$ \\
\bottomrule
\end{tabular}

\begin{list}{}{\equationlist{$\mathrm{L\_1} =$}}
\item[$\mathrm{L\_1} =$] ${\uparrow}X_{1} + \overline{{\downarrow}X_{\mathrm{wait}} \cdot \overline{{\uparrow}X_{1}}} \cdot \mathrm{L\_1}$
\end{list}

\subsection*{\raggedright Counters}

\noindent\begin{tabular}{@{}llll@{}}
\toprule
Counter & Range & When & Write \\
\midrule
$n$ & 0..9 & $X_{0} \cdot {\uparrow}m \cdot {[n < 9]} \cdot \overline{\mathrm{Init}}$ & $n := n + 1$ \\
\bottomrule
\end{tabular}

\subsection*{\raggedright Time conditions}

\noindent\begin{tabular}{@{}llll@{}}
\toprule
Time condition & Operand & 1 after & 0 after \\
\midrule
$1.5\,\mathrm{s}/X_{\mathrm{wait}}/20\,\mathrm{ms}$ & $X_{\mathrm{wait}}$ & 1.5s & 20ms \\
\bottomrule
\end{tabular}

\subsection*{\raggedright Edges}

\noindent\begin{tabular}{@{}ll@{}}
\toprule
Edge & Operand \\
\midrule
${\uparrow}m$ & $m$ \\
\bottomrule
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
  "transitions": [
    {"name":"0","from":["X0"],"to":["X1"],"condition":"↑m.[n < 9]","clearing":"X0.↑m.[n < 9]"},
    {"name":"1","from":["X1"],"to":["Xwait"],"condition":"\"H|+\".m + /m.\"H|+\"","clearing":"X1.(\"H|+\".m + /m.\"H|+\")"},
    {"name":"2","from":["Xwait"],"to":["X0"],"condition":"1.5s/Xwait/20ms","clearing":"Xwait . 1.5s/Xwait/20ms"}
  ],
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

Transitions
  Transition  Étapes    Réceptivité  Condition de franchissement
  (0)         X0 -> X1  m.b + m./b   X0.(m.b + m./b)
  (1)         X1 -> X0  b            X1.b

Conditions d'activation et de désactivation
  Étape  CAX              CDX
  X0     X1.b             X0.(m.b + m./b)
  X1     X0.(m.b + m./b)  X1.b

Équations des étapes
  X0 = X1.b + /(X0.(m.b + m./b)).X0
  X1 = X0.(m.b + m./b) + /(X1.b).X1

Table de vérité et tableau de Karnaugh d'une étape
Ils sont les mêmes pour toutes les étapes.
  X(t)  CAX  CDX  X(t+dt)  Remarque
  0     0    0    0        L'étape reste inactive (effet mémoire)
  0     0    1    0        L'étape reste inactive
  0     1    0    1        Activation de l'étape
  0     1    1    1        Activation ET désactivation = activation
  1     0    0    1        L'étape reste active (effet mémoire)
  1     0    1    0        Désactivation de l'étape
  1     1    0    1        L'étape reste active
  1     1    1    1        Activation ET désactivation = activation

     CAX CDX
  X  00   01  11   10
  0  0    0   1 a  1 a
  1  1 b  0   1 a  1 ab

  Groupe  Produit  Cases (X, CAX CDX)
  a       CAX      0, 11; 0, 10; 1, 11; 1, 10
  b       /CDX.X   1, 00; 1, 10

  X = CAX + /CDX.X

Formes réduites
  CDX0 = X0.m
  X0 = X1.b + /m.X0
  CAX1 = X0.m
  X1 = X0.m + /b.X1
)report");
}

TEST_CASE("truth table and Karnaugh map in English") {
    const std::string text = report(two_steps, {.karnaugh = true});
    CHECK(text.substr(text.find("\nTruth table and Karnaugh map of a step\n")) == R"report(
Truth table and Karnaugh map of a step
They are the same for every step.
  X(t)  CAX  CDX  X(t+dt)  Remark
  0     0    0    0        The step stays inactive (memory effect)
  0     0    1    0        The step stays inactive
  0     1    0    1        Activation of the step
  0     1    1    1        Activation AND deactivation = activation
  1     0    0    1        The step stays active (memory effect)
  1     0    1    0        Deactivation of the step
  1     1    0    1        The step stays active
  1     1    1    1        Activation AND deactivation = activation

     CAX CDX
  X  00   01  11   10
  0  0    0   1 a  1 a
  1  1 b  0   1 a  1 ab

  Group  Product  Cells (X, CAX CDX)
  a      CAX      0, 11; 0, 10; 1, 11; 1, 10
  b      /CDX.X   1, 00; 1, 10

  X = CAX + /CDX.X

Smaller forms
  CAX1 = X0.m./Init
  X1 = X0.m./Init./AUdur + /X0.X1./Init./AUdur
)report");
}

TEST_CASE("truth table and Karnaugh map in LaTeX") {
    const std::string text =
        report(two_steps, {.format = EquationFormat::latex, .karnaugh = true}, without_modes);
    CHECK(text.substr(text.find(
              "\n\\subsection*{\\raggedright Truth table and Karnaugh map of a step}\n")) ==
          R"report(
\subsection*{\raggedright Truth table and Karnaugh map of a step}

\noindent They are the same for every step.

\medskip\noindent\begin{tabular}{@{}lllll@{}}
\toprule
$X(t)$ & $\mathit{CAX}$ & $\mathit{CDX}$ & $X(t+dt)$ & Remark \\
\midrule
0 & 0 & 0 & 0 & The step stays inactive (memory effect) \\
0 & 0 & 1 & 0 & The step stays inactive \\
0 & 1 & 0 & 1 & Activation of the step \\
0 & 1 & 1 & 1 & Activation AND deactivation = activation \\
1 & 0 & 0 & 1 & The step stays active (memory effect) \\
1 & 0 & 1 & 0 & Deactivation of the step \\
1 & 1 & 0 & 1 & The step stays active \\
1 & 1 & 1 & 1 & Activation AND deactivation = activation \\
\bottomrule
\end{tabular}

\medskip\noindent{\renewcommand{\arraystretch}{1.3}\begin{tabular}{c|c|c|c|c|}
\multicolumn{1}{c}{} & \multicolumn{4}{c}{$\mathit{CAX}\;\mathit{CDX}$} \\
\multicolumn{1}{c}{$X$} & \multicolumn{1}{c}{00} & \multicolumn{1}{c}{01} & \multicolumn{1}{c}{11} & \multicolumn{1}{c}{10} \\
\cline{2-5}
0 & 0 & 0 & 1 a & 1 a \\
\cline{2-5}
1 & 1 b & 0 & 1 a & 1 ab \\
\cline{2-5}
\end{tabular}}

\medskip\noindent\begin{tabular}{@{}lll@{}}
\toprule
Group & Product & Cells (X, CAX CDX) \\
\midrule
a & $\mathit{CAX}$ & 0, 11; 0, 10; 1, 11; 1, 10 \\
b & $\overline{\mathit{CDX}} \cdot X$ & 1, 00; 1, 10 \\
\bottomrule
\end{tabular}

\begin{list}{}{\equationlist{$X =$}}
\item[$X =$] $\mathit{CAX} + \overline{\mathit{CDX}} \cdot X$
\end{list}

\subsection*{\raggedright Smaller forms}

\begin{list}{}{\equationlist{$\mathit{CAX}_{1} =$}}
\item[$\mathit{CAX}_{1} =$] $X_{0} \cdot m$
\item[$X_{1} =$] $X_{0} \cdot m + \overline{X_{0}} \cdot X_{1}$
\end{list}
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
    has(EquationFormat::latex,
        "\\item[$\\text{x,y} =$] $X_{\\text{my step}} \\cdot \\text{50\\%}$\n");
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
    CHECK(text.find(R"($X_{0} \cdot ((a \oplus b) \cdot c \allowbreak + )"
                    R"(\overline{\overline{a + b} \cdot c} \cdot {\downarrow}(a \cdot b))$)") !=
          std::string::npos);
    CHECK(text.find(R"($X_{1} \cdot 2\,\mathrm{s}/(3\,\mathrm{s}/a/1\,\mathrm{min}) )"
                    R"(\cdot 1\,\mathrm{s}/\overline{b}$)") != std::string::npos);
}

TEST_CASE("LaTeX: a negation too long for an overline has a slash, and a note says so") {
    constexpr std::string_view chart = R"(
        input first_input, second_input, third_input
        graph G { initial 0 step 1
                  0 -> 1 : /(first_input + second_input + third_input)   1 -> 0 : /first_input })";
    const std::string text = report(
        chart, {.format = EquationFormat::latex, .language = Language::french}, without_modes);
    INFO(text);
    CHECK(text.find("$/(\\mathrm{first\\_input} + \\mathrm{second\\_input}") != std::string::npos);
    CHECK(text.find("\\overline{\\mathrm{first\\_input} + \\mathrm{second\\_input}") !=
          std::string::npos);
    CHECK(text.find("\n\\noindent Une barre oblique devant une parenthèse note") !=
          std::string::npos);
    CHECK(report(lamp, {.format = EquationFormat::latex}).find("slash") == std::string::npos);
}

TEST_CASE("LaTeX: names that are long, of other alphabets, or of signs that join") {
    const std::string text = report(R"(
        input "θ", "日", "a--b", a_name_longer_than_a_column_is_wide
        graph G { initial 0 step 1
                  0 -> 1 : "θ" . "日" . "a--b"   1 -> 0 : a_name_longer_than_a_column_is_wide })",
                                    {.format = EquationFormat::latex}, without_modes);
    INFO(text);
    CHECK(text.find(R"(\text{\ensuremath{\theta}} \cdot \text{U+65E5} \cdot \text{a-{}-b})") !=
          std::string::npos);
    CHECK(text.find(R"(\mathrm{a\_name\_}\penalty999 \mathrm{longer\_}\penalty999 )") !=
          std::string::npos);
}

TEST_CASE("LaTeX: a whole document in the language of the report") {
    const std::string text =
        report(two_steps,
               {.format = EquationFormat::latex, .language = Language::french, .standalone = true});
    INFO(text);
    CHECK(text.rfind("% " + program_and_version() + "\n\\documentclass[a4paper]{article}\n", 0) ==
          0);
    CHECK(text.find("\\usepackage[french]{babel}\n") != std::string::npos);
    CHECK(text.substr(text.size() - 15) == "\\end{document}\n");
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
