#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "grafcet/grafcet_builder.h"
#include "grafcet/lexer.h"
#include "grafcet/name_table.h"

namespace grafwire {

/// Reads the text of a chart and tells a builder what stands in it. What it does not understand it
/// reports, and goes on at the next step, transition, declaration or graph, so that one file gives
/// all its errors.
class ChartParser : private TokenReader {
  public:
    ChartParser(std::string_view source, GrafcetBuilder& builder, Diagnostics& diagnostics)
        : TokenReader(source, diagnostics), source_(source), builder_(builder) {}

    using TokenReader::keep_tokens_in;
    void parse_file();

  private:
    /// The block whose parts are being read.
    struct OpenBlock {
        BlockId id{};
        bool is_expansion = false;
    };
    /// What a step encloses, before the step itself is told to the builder.
    struct NamedEnclosure {
        Name graph;
        std::vector<Name> links;
    };

    void reserve();
    void parse_header();
    void parse_item();
    bool parse_declaration();
    bool parse_counter();
    void declare_variable(const Name& read);
    bool parse_define();
    bool parse_time();
    bool parse_bound(std::int64_t& value);
    bool parse_assumption();
    // After an error: to what may begin the next part.
    void recover_in_file();
    void recognise();
    bool at_declaration() const;
    bool at_file_item() const;
    bool at_block_item() const;

    // Inside a block.
    void parse_block();
    void parse_block_item(OpenBlock block);
    void recover_in_block();
    bool parse_step(BlockId block);
    bool parse_enclosure(std::optional<NamedEnclosure>& enclosure);
    bool parse_macro(BlockId block);
    bool parse_entry_or_exit(OpenBlock block);
    bool parse_transition(BlockId block);
    bool parse_side(std::vector<Name>& names, bool is_preceding);
    bool parse_condition(NamedTransition& transition);
    bool refuse_parenthesis();
    bool refuse_action(const Name& read);
    bool parse_actions(GrafcetBuilder::StepKey step);
    bool parse_action(GrafcetBuilder::StepKey step);
    bool parse_stored(GrafcetBuilder::StepKey step, const Name* target);
    bool parse_order(GrafcetBuilder::StepKey step, Name graph);
    bool parse_write(NamedWrite& write, const Name* target);

    std::string_view source_;
    GrafcetBuilder& builder_;
    bool has_blocks_ = false;
    /// Of each variable declared so far; tells a sum from a Boolean expression after `:=`.
    NameTable<bool> is_counter_;
    std::uint32_t open_brace_line_ = 0;  ///< of the `{` of an order or enclosure being read, or 0
    // Used again for each part of the text, so that a long chart asks for memory once.
    NamedTransition transition_;
    NamedExpression expression_;
};

/// parse_grafcet() that hands over the tokens of the text as well.
std::optional<Grafcet> parse_keeping_tokens(const SourceFile& source,
                                            std::vector<ReadToken>& tokens,
                                            Diagnostics& diagnostics);

// Both read from the present token on and report what they do not understand; they return false
// then.

/// A Boolean expression. It is empty if it has not been understood.
bool parse_expression(TokenReader& tokens, NamedExpression& expression);

/// A duration, which may be too long, in picoseconds.
bool parse_duration_token(TokenReader& tokens, std::optional<Time>& value);

/// A sum of counters and numbers.
bool parse_sum(TokenReader& tokens, NamedSum& sum);

}  // namespace grafwire
