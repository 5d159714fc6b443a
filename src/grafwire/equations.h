#pragma once

#include <string>

#include "grafwire/read.h"

namespace grafwire::api {

/// How the deactivation of a step (CDX) is derived: from the steps that follow, or from the
/// transitions that are cleared.
enum class Cdx { successor, transition };

struct EquationOptions {
    Cdx cdx = Cdx::successor;
    bool modes = true;      ///< with Init, AUdur and AUdoux
    bool karnaugh = false;  ///< with truth tables, Karnaugh maps and minimised forms; not in CSV
    Language language = Language::english;  ///< of text, Markdown and LaTeX
    bool standalone = false;                ///< LaTeX: a whole document
};

enum class EquationForm { text, markdown, latex, csv, json };

/// CAX, CDX and X of every step and the equations of the outputs, written down.
std::string equations(const Chart& chart, EquationForm form, const EquationOptions& options = {});

}  // namespace grafwire::api
