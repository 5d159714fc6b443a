#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "program/program.h"
#include "s7/generate/addresses.h"
#include "s7/generate/condition_writer.h"
#include "s7/generate/network_list.h"
#include "s7/generate/timers.h"

namespace grafwire::s7 {

/// Makes the networks of a listing (see listing_from.cpp); the members are what its parts share.
class ListingBuild {
  public:
    ListingBuild(const Grafcet& grafcet, const ScanProgram& program, Addresses& addresses,
                 const std::vector<TimeConditionTimers>& timers, Language language)
        : grafcet_(grafcet),
          program_(program),
          addresses_(addresses),
          timers_(timers),
          networks_(language),
          conditions_(addresses, networks_) {}

    NetworkList make_networks();

  private:
    // listing_sections.cpp
    void main_program();
    void subroutine(int number, const Message<>& comment);
    void call(int number, const Localized& comment);
    void end_subroutine();
    /// `NOP K0` where the chart has nothing to put.
    void nothing(const Message<>& comment);
    void clear_tables();
    /// target = before . /off + on over whole tables; `on` is left out where equal to `off`.
    void formula(const Localized& comment, BitKind before, BitKind off, BitKind on, BitKind target);
    void make_begin();
    void make_pulse();
    void fill(std::int64_t value, std::uint32_t first, std::uint32_t bytes,
              std::vector<Instruction>& out) const;

    void make_start();
    void make_initial_steps();
    void make_initialisation();
    bool start_reads(BitKind kind) const;
    std::vector<Operand> bits_to_clear() const;
    void reset_timers();

    void make_plain(SectionKind section);
    void make_evolution();
    void make_orders();

    // listing_statements.cpp
    void write(const Statement& statement);
    void write_assign(const Statement& statement);
    void write_set_or_reset(const Statement& statement);
    void write_move(const Statement& statement);
    void hold_within(const IntegerRange& range, const Statement& statement);
    void write_time(const Statement& statement);
    void add(const Localized& comment, const Condition& condition, std::vector<Instruction> work);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Addresses& addresses_;
    const std::vector<TimeConditionTimers>& timers_;
    NetworkList networks_;
    ConditionWriter conditions_;
};

/// Whether a statement is the operation on whole tables.
inline bool is_table(const Statement& statement, TableOperation operation) {
    return statement.kind == Statement::Kind::table && statement.operation == operation;
}

}  // namespace grafwire::s7
