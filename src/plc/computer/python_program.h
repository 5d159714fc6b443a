#pragma once

#include <string>
#include <string_view>

#include "plc/shared/condition_text.h"
#include "plc/shared/program_names.h"
#include "plc/shared/source_text.h"
#include "program/program.h"

namespace grafwire {

/// Writes a program in Python 3; the members are what its parts share.
class PythonProgram {
  public:
    PythonProgram(const Grafcet& grafcet, const ScanProgram& program, Language language);

    std::string write();

  private:
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const {
        return cell.is_scratch ? names_[cell] : "self.counters." + names_[cell];
    }
    // write_python.cpp
    void write_head();
    void write_steps();
    void write_inputs();
    void write_class();
    void write_start();
    /// `self.name = SimpleNamespace(a=value, …)`, where the program has any use for it.
    void write_group(BitKind kind, std::size_t count, std::string_view value,
                     const Message<>& comment);
    void write_run();
    // python_statements.cpp
    void write_section(SectionKind section);
    void write_scan();
    void write(const Statement& statement);
    void write_actions(const Statement& statement);
    std::string table_text(TableOperation operation) const;
    /// A line that may need parentheses to go on in the next one.
    void write_line(std::string_view before, std::string_view expression, std::string_view after);

    const Grafcet& grafcet_;
    ScanProgram program_;
    Language language_;
    ProgramNames names_;
    ConditionText conditions_;
    SourceText out_{"#", SourceText::Breaks::within_parentheses};
};

}  // namespace grafwire
