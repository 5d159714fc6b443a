// Statement List for STEP 7.
//
// The tables are words of bit memory, so the whole-table formulas of the method are a few
// operations on words, whatever the number of steps up to 32. Operands are absolute, each with its
// symbol behind it, so that the file compiles without a symbol table; the assignment stands at the
// head. The situation is set up again at every restart, because bit memory may be retentive.

#include "plc/step7/write_stl.h"

#include <fmt/format.h>

#include "grafcet/grafcet.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "plc/step7/messages.h"
#include "plc/step7/stl_instructions.h"
#include "plc/step7/stl_memory.h"
#include "plc/step7/stl_timers.h"
#include "program/bit_names.h"
#include "program/messages.h"

namespace grafwire {

namespace {

namespace say = messages::plc_step7;

class StlWriter {
  public:
    StlWriter(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
              unsigned integer_bits, Diagnostics& diagnostics)
        : grafcet_(grafcet),
          program_(program),
          language_(options.language),
          made_by_(options.made_by),
          integer_bytes_(integer_bits / 8),
          memory_(grafcet, program_, options, integer_bits == 32, diagnostics),
          text_(options.mnemonics),
          conditions_(memory_, text_, integer_bytes_),
          timers_(memory_, text_, conditions_, options.language),
          started_(memory_.new_bit()) {
        timers_.prepare(program_, diagnostics);
    }

    std::string write(Diagnostics& diagnostics);

  private:
    std::string head() const;
    std::string symbols() const;
    void write_start();
    void write_section(SectionKind kind);
    void write_statement(const Statement& statement);
    void write_table(TableOperation operation);
    void write_formula(BitKind before, BitKind off, BitKind on, std::uint32_t at);
    void write_move(const Statement& statement);
    void write_limit(const Statement& statement, const char* relation, std::int64_t limit);
    void write_blocks();

    std::string new_label() { return fmt::format("m{:03d}", labels_++); }
    /// One word of a table.
    std::string word(BitKind kind, std::uint32_t at) const {
        return StlText::word(memory_.table(kind) + at, memory_.word_bytes());
    }
    /// `UW` or `UD`.
    std::string word_op(std::string_view operation) const {
        return std::string(operation) + (memory_.word_bytes() == 2 ? "W" : "D");
    }
    std::string inversion() const { return memory_.word_bytes() == 2 ? "INVI" : "INVD"; }
    void op(std::string_view operation, Bit bit) {
        text_.op(operation, text_.operand(memory_.of(bit)), memory_.symbol(bit));
    }

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    std::string made_by_;
    std::uint32_t integer_bytes_;
    StlMemory memory_;
    StlText text_;
    StlConditions conditions_;
    StlTimers timers_;
    StlAddress started_;
    std::uint32_t labels_ = 1;
};

std::string StlWriter::symbols() const {
    std::string table;
    const auto add = [&](const std::string& operand, const std::string& symbol) {
        table += fmt::format("//   {:<10} {}\n", operand, symbol);
    };
    const auto add_bits = [&](BitKind kind, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            add(text_.operand(memory_.of(Bit{kind, i})), memory_.symbol(Bit{kind, i}));
        }
    };
    add_bits(BitKind::input, grafcet_.inputs.size());
    if (program_.has_modes) add_bits(BitKind::control, control_input_count);
    add_bits(BitKind::output, grafcet_.outputs.size());
    add_bits(BitKind::var, grafcet_.vars.size());
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const IntegerCell cell{false, c};
        add(StlText::word(memory_.of(cell), integer_bytes_), memory_.symbol(cell));
    }
    add_bits(BitKind::step, grafcet_.steps.size());
    return table;
}

std::string StlWriter::head() const {
    StlText text(s7::Mnemonics::simatic);
    text.comment(titled_name(grafcet_.name, grafcet_.title, language_));
    if (!made_by_.empty()) text.comment(made_by_);
    text.comment(say::what_it_is.in(language_));
    if (program_.has_modes) text.comment(say::modes.in(language_));
    text.comment(say::memory_used.in(language_, StlMemory::first_byte, memory_.end() - 1));
    text.comment({});
    text.comment(say::assignment.in(language_));
    return text.take() + symbols() + "\n";
}

/// Everything is 0 before the first scan, timers included.
void StlWriter::write_start() {
    const std::string after = new_label();
    text_.op("UN", text_.operand(started_), say::not_first_scan.in(language_));
    text_.op("SPBN", after);
    text_.comment(say::everything_is_0.in(language_));
    text_.op("L", "0");
    for (std::uint32_t at = StlMemory::first_byte; at < memory_.program_end();) {
        const std::uint32_t left = memory_.program_end() - at;
        if (left == 1 || left == 3) {
            text_.op("T", fmt::format("MB {}", at));
            at += 1;
            continue;
        }
        const std::uint32_t bytes = left == 2 ? 2 : 4;
        text_.op("T", StlText::word(at, bytes));
        at += bytes;
    }
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        if (!grafcet_.outputs[OutputId{o}].stored) continue;
        text_.op("CLR");
        op("=", {BitKind::output, o});
    }
    timers_.write_start();
    text_.op("SET");
    text_.op("=", text_.operand(started_));
    for (const Statement& statement : program_.section(SectionKind::start)) {
        write_statement(statement);
    }
    text_.label(after);
}

void StlWriter::write_section(SectionKind kind) {
    if (kind == SectionKind::start) {
        text_.network(section_title(kind).in(language_));
        return write_start();
    }
    if (program_.section(kind).empty()) return;
    text_.network(section_title(kind).in(language_));
    for (const Statement& statement : program_.section(kind)) write_statement(statement);
}

/// table = before . /off + on, a word at a time.
void StlWriter::write_formula(BitKind before, BitKind off, BitKind on, std::uint32_t at) {
    text_.op("L", word(off, at));
    text_.op(inversion());
    text_.op("L", word(before, at));
    text_.op(word_op("U"));
    text_.op("L", word(on, at));
    text_.op(word_op("O"));
    text_.op("T", word(BitKind::step, at));
}

void StlWriter::write_table(TableOperation operation) {
    for (std::uint32_t at = 0; at < memory_.table_bytes(); at += memory_.word_bytes()) {
        switch (operation) {
            case TableOperation::remember:
                text_.op("L", word(BitKind::step, at));
                text_.op("T", word(BitKind::previous, at));
                break;
            case TableOperation::clear:
                text_.op("L", "0");
                text_.op("T", word(BitKind::activate, at));
                text_.op("T", word(BitKind::deactivate, at));
                if (!has_forcing(program_)) break;
                text_.op("T", word(BitKind::forced_on, at));
                text_.op("T", word(BitKind::forced_off, at));
                break;
            case TableOperation::evolve:
                write_formula(BitKind::previous, BitKind::deactivate, BitKind::activate, at);
                break;
            case TableOperation::force:
                write_formula(BitKind::step, BitKind::forced_off, BitKind::forced_on, at);
                break;
            case TableOperation::pulse:
                text_.op("L", word(BitKind::previous, at));
                text_.op(inversion());
                text_.op("L", word(BitKind::step, at));
                text_.op(word_op("U"));
                text_.op("T", word(BitKind::pulse, at));
                break;
        }
    }
}

/// Where the integer in accumulator 1, just written, lies beyond a limit, the limit.
void StlWriter::write_limit(const Statement& statement, const char* relation, std::int64_t limit) {
    const std::string after = new_label();
    conditions_.load_constant(limit);
    text_.op(conditions_.integer_op(relation));
    text_.op("SPBN", after);
    conditions_.load_constant(limit);
    text_.op("T", conditions_.word(statement.integer), memory_.symbol(statement.integer));
    text_.label(after);
}

void StlWriter::write_move(const Statement& statement) {
    const bool always = statement.condition.is_constant(true);
    const std::string after = always ? "" : new_label();
    if (!always) {
        conditions_.load(statement.condition);
        text_.op("SPBN", after);
    }
    if (statement.sum.empty()) {
        conditions_.load(statement.source);
    } else {
        conditions_.load(statement.sum);
    }
    text_.op("T", conditions_.word(statement.integer), memory_.symbol(statement.integer));
    if (!statement.sum.empty()) {
        // What lies within the range anyway needs no limits.
        const IntegerRange range = value_range(grafcet_, statement.sum);
        const bool too_low = range.low < statement.low;
        const bool too_high = range.high > statement.high;
        if (too_low) write_limit(statement, "<", statement.low);
        if (too_low && too_high) conditions_.load(statement.integer);
        if (too_high) write_limit(statement, ">", statement.high);
    }
    if (!always) text_.label(after);
}

void StlWriter::write_statement(const Statement& statement) {
    text_.comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            conditions_.load(statement.condition);
            op("=", statement.targets.front());
            break;
        case Statement::Kind::set:
        case Statement::Kind::reset:
            conditions_.load(statement.condition);
            for (const Bit bit : statement.targets) {
                op(statement.kind == Statement::Kind::set ? "S" : "R", bit);
            }
            break;
        case Statement::Kind::move:
            write_move(statement);
            break;
        case Statement::Kind::time:
            timers_.write(statement);
            break;
        case Statement::Kind::table:
            write_table(statement.operation);
            break;
    }
}

/// What calls the scan.
void StlWriter::write_blocks() {
    text_.line("END_FUNCTION\n");
    text_.line(fmt::format("ORGANIZATION_BLOCK OB 1\nTITLE = {}\nVERSION : 0.1\n",
                           say::every_cycle.in(language_)));
    text_.line("VAR_TEMP\n      info : ARRAY[0..19] OF BYTE;\nEND_VAR\n\nBEGIN\nNETWORK");
    text_.op("UC", "FC 1");
    text_.line("END_ORGANIZATION_BLOCK\n");
    text_.line(fmt::format("ORGANIZATION_BLOCK OB 100\nTITLE = {}\nVERSION : 0.1\n",
                           say::restart.in(language_)));
    text_.line("VAR_TEMP\n      info : ARRAY[0..19] OF BYTE;\nEND_VAR\n\nBEGIN\nNETWORK");
    text_.op("CLR");
    text_.op("=", text_.operand(started_), say::next_scan_is_first.in(language_));
    text_.line("END_ORGANIZATION_BLOCK");
}

std::string StlWriter::write(Diagnostics& diagnostics) {
    timers_.write_data_blocks();
    text_.line(fmt::format("FUNCTION FC 1 : VOID\nTITLE = {}\nVERSION : 0.1\n\nBEGIN",
                           say::one_scan.in(language_)));
    for (std::size_t s = 0; s < section_count; ++s) write_section(static_cast<SectionKind>(s));
    write_blocks();
    memory_.check_size(diagnostics);
    if (labels_ > 1000) {
        diagnostics.error(code::unsupported_by_language, {}, say::too_many_labels());
    }
    if (diagnostics.has_errors()) return {};
    return head() + text_.take();
}

}  // namespace

std::string write_stl(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics) {
    const ScanProgram needed = without_idle_tables(program);
    const std::optional<unsigned> bits = integer_bits(grafcet, needed);
    if (!bits || *bits > 32) {
        diagnostics.error(code::unsupported_by_language, wide_integer(grafcet, needed, 32),
                          say::integer_too_wide());
        return {};
    }
    return StlWriter(grafcet, needed, options, *bits, diagnostics).write(diagnostics);
}

}  // namespace grafwire
