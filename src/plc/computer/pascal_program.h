#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plc/shared/condition_text.h"
#include "plc/shared/program_names.h"
#include "plc/shared/source_text.h"
#include "program/program.h"

namespace grafwire {

/// Writes a program in Free Pascal; the members are what its parts share.
class PascalProgram {
  public:
    PascalProgram(const Grafcet& grafcet, const ScanProgram& program, Language language);

    std::string write();

  private:
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const {
        return cell.is_scratch ? names_[cell] : "counters." + names_[cell];
    }
    // write_pascal.cpp
    void write_head();
    void write_types();
    void write_variables();
    /// `name: record a, b: type; end;`, where there is any field.
    void write_record(std::string_view name, const std::vector<std::string>& fields,
                      std::string_view type, const Message<>& comment);
    std::vector<std::string> names_of(BitKind kind, std::size_t count) const;
    void write_row();
    void write_main();
    // pascal_statements.cpp
    void write_section(SectionKind section);
    void write_scratch(SectionKind section);
    void write_scan();
    void write(const Statement& statement);
    std::vector<std::string> actions_of(const Statement& statement) const;
    void write_table(TableOperation operation);

    const Grafcet& grafcet_;
    ScanProgram program_;
    Language language_;
    ProgramNames names_;
    ConditionText conditions_;
    SourceText out_{"//"};
};

}  // namespace grafwire
