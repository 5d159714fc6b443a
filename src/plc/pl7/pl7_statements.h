#pragma once

#include <string>

#include "plc/pl7/pl7_objects.h"
#include "plc/pl7/pl7_rungs.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/language.h"

namespace grafwire {

/// Writes statements of a program as rungs, each with its condition as contacts. An error for each
/// duration that no timer holds exactly.
class Pl7Statements {
  public:
    Pl7Statements(const Grafcet& grafcet, const ScanProgram& program, Pl7Objects& objects,
                  Pl7Rungs& rungs, Language language, Diagnostics& diagnostics)
        : grafcet_(grafcet),
          program_(program),
          objects_(objects),
          rungs_(rungs),
          language_(language),
          diagnostics_(diagnostics) {}

    /// Names the time conditions that are the end of a timer; before anything reads them.
    void name_timers();
    /// A label and the rungs of a statement of any kind but table.
    void write(const Statement& statement);

  private:
    void write_move(const Statement& statement);
    void write_time(const Statement& statement);
    void run_timer(const std::string& timer, Time duration, const Condition& condition,
                   Location where);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Pl7Objects& objects_;
    Pl7Rungs& rungs_;
    Language language_;
    Diagnostics& diagnostics_;
};

}  // namespace grafwire
