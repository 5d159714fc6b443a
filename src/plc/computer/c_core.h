#pragma once

#include <string>

#include "plc/shared/condition_text.h"
#include "plc/shared/program_names.h"
#include "plc/shared/source_text.h"
#include "program/program.h"

namespace grafwire {

/// The scan of a program in the part that C99 and C++ have in common: a struct that holds all that
/// one scan hands to the next, and the functions NAME_start and NAME_scan. The tables of steps are
/// words of 32 bits; everything else is a bool of its own.
class CCore {
  public:
    CCore(const Grafcet& grafcet, const ScanProgram& program, const NameRules& rules,
          Language language);

    const ProgramNames& names() const { return names_; }
    /// `int32_t` where that is wide enough for all counters and sums, else `int64_t`.
    std::string_view integer_type() const { return wide_ ? "int64_t" : "int32_t"; }

    /// The enumeration of the steps and the structs.
    std::string types() const;
    /// The functions; those that help only where they are called.
    std::string functions() const;

    /// An operand of an expression, in a function whose `g` points to the struct.
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const;

  private:
    void write_inputs(SourceText& out) const;
    void write_outputs(SourceText& out) const;
    void write_state(SourceText& out) const;
    /// `struct { bool a, b; } name;`, where the program has any use for it.
    void write_group(SourceText& out, BitKind kind, std::size_t count,
                     const Message<>& comment) const;
    void write_section(SourceText& out, SectionKind section) const;
    void write_entry_points(SourceText& out) const;
    void write(SourceText& out, const Statement& statement) const;
    void write_table(SourceText& out, TableOperation operation) const;
    void write_assignment(SourceText& out, const Statement& statement) const;
    void write_targets(SourceText& out, const Statement& statement) const;
    std::string move_text(const Statement& statement) const;

    const Grafcet& grafcet_;
    ScanProgram program_;
    ProgramNames names_;
    bool wide_;
    ConditionText conditions_;
    Language language_;
};

}  // namespace grafwire
