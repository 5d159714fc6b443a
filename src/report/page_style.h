#pragma once

#include <string_view>

namespace grafwire {

/// How the page looks: on screens, light and dark, and on A4 paper, where no picture and no row is
/// cut by the end of a sheet that fits on one.
inline constexpr std::string_view page_style = R"(:root { color-scheme: light dark; }
body { font: 16px/1.5 "DejaVu Sans", Arial, sans-serif; max-width: 75rem; margin: 0 auto; padding: 1rem 1.5rem; color: #1b1b1b; background: #ffffff; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { font-size: 1.3rem; margin: 2.2rem 0 0.6rem; border-bottom: 1px solid #9a9a9a; }
h3 { font-size: 1.05rem; margin: 1.4rem 0 0.4rem; }
nav h2 { font-size: 1.05rem; margin-top: 1rem; border: none; }
nav ul { columns: 18rem 3; margin: 0; padding-left: 1.2rem; }
a { color: #0b57a4; }
figure { margin: 1rem 0; overflow-x: auto; }
svg { max-width: 100%; height: auto; display: block; }
table { border-collapse: collapse; margin: 0.6rem 0; }
th, td { border: 1px solid #9a9a9a; padding: 0.25rem 0.6rem; text-align: left; vertical-align: top; overflow-wrap: anywhere; }
th { background: #eeeeee; }
td p { margin: 0; font-size: 0.875rem; }
code, pre { font-family: "DejaVu Sans Mono", Consolas, monospace; font-size: 0.875rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; background: #f4f4f4; padding: 0.7rem; line-height: 1.4; }
ul.equations { list-style: none; padding-left: 0; }
strong { white-space: nowrap; }
strong.equivalent::before { content: "\2713 "; }
strong.different::before { content: "\2717 "; }
strong.undecided::before { content: "? "; }
strong.equivalent { color: #1e6b2f; }
strong.different { color: #b3261e; }
strong.undecided { color: #7a5200; }
footer { margin-top: 2.5rem; font-size: 0.875rem; }
@media screen and (prefers-color-scheme: dark) {
body { color: #e3e6ea; background: #16191d; }
a { color: #8ab8ff; }
th { background: #262b31; }
th, td, h2 { border-color: #5a626b; }
pre { background: #20252a; }
strong.equivalent { color: #7ed492; }
strong.different { color: #ff8a80; }
strong.undecided { color: #f0c05a; }
}
@page { size: A4; margin: 15mm; }
@media print {
body { font-size: 10pt; max-width: none; padding: 0; color: #000000; }
h1, h2, h3, section > p { break-after: avoid; }
figure, tr { break-inside: avoid; }
figure { overflow: visible; }
svg { max-height: 255mm; }
a { color: inherit; text-decoration: none; }
pre, th { background: none; }
pre { border: 1px solid #9a9a9a; font-size: 8.5pt; }
code { font-size: 9pt; }
}
)";

}  // namespace grafwire
