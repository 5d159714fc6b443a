// A listing goes by lines. What is wrong with one leaves the next alone, so that all errors are
// reported in one go. Printed listings are read as well: what the reader puts right (see
// parse_listing.h) it counts, and tells once for each kind, with the first place.

#include "s7/parse_listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "s7/check_listing.h"
#include "s7/instruction_set.h"
#include "s7/listing_items.h"
#include "s7/listing_lines.h"
#include "s7/messages.h"
#include "text/nearest_name.h"
#include "text/utf8.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7;

void append_comment(std::string& comment, std::string_view text) {
    if (text.empty()) return;
    if (!comment.empty()) comment += ' ';
    comment += visible(text);
}

class ListingReader {
  public:
    ListingReader(const ReadingOptions& options, Diagnostics& diagnostics)
        : options_(options), diagnostics_(diagnostics) {}

    void read_line(std::string_view text, std::uint32_t number) {
        const ListingLine line = split_line(text, number);
        if (line.unterminated.is_known()) {
            error(code::unterminated_text, line.unterminated, say::unterminated_name());
        }
        if (comment_is_open_ && !line.words.empty() && !begins_item(line.words)) {
            add_network_comment(joined(line), line.words.front().where);
            note_lenient(say::continued_comment(), line.words.front().where);
            return;
        }
        comment_is_open_ = false;
        if (line.words.empty()) {
            if (line.has_comment) add_comment_line(line.comment, line.comment_at);
            return;
        }
        read_items(line);
    }

    Listing finish() {
        order_columns(items_, diagnostics_);
        for (const auto& [key, found] : lenient_) {
            diagnostics_.warning(
                code::read_leniently, found.first,
                found.count == 1 ? found.what : say::and_elsewhere(found.count - 1, found.what));
        }
        assemble(std::move(items_), listing_, diagnostics_);
        return std::move(listing_);
    }

  private:
    Diagnostic& error(Code code, Location where, Localized message) {
        return diagnostics_.error(code, where, std::move(message));
    }

    void note_lenient(Localized what, Location where) {
        Lenient& found = lenient_[what.english];
        if (found.count++ != 0) return;
        found.what = std::move(what);
        found.first = where;
    }

    static std::string joined(const ListingLine& line) {
        std::string text;
        for (const ListingWord& word : line.words) append_comment(text, word.text);
        append_comment(text, line.comment);
        return text;
    }

    /// Whether a line below a comment is more than the rest of it: a network, or something that
    /// looks like an instruction, be it a mistyped one.
    static bool begins_item(const std::vector<ListingWord>& words) {
        if (network_digits(words[0])) return true;
        const std::size_t first = is_offset(words[0]) && words.size() > 1 ? 1 : 0;
        if (instruction_named(words[first].text)) return true;
        if (first + 1 < words.size()) return parse_operand(words[first + 1].text).has_value();
        return first == 1 || words[0].text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") ==
                                 std::string_view::npos;
    }

    /// A line that is nothing but a comment belongs to what stands before it.
    void add_comment_line(std::string_view comment, Location where) {
        if (items_.empty()) {
            listing_.head.push_back(visible(comment));
            return;
        }
        if (items_.back().is_network) {
            add_network_comment(comment, where);
        } else {
            append_comment(items_.back().instruction.comment, comment);
        }
    }

    void read_items(const ListingLine& line) {
        std::size_t at = 0;
        const std::string_view comment = line.comment;
        for (std::uint8_t column = 0; at < line.words.size(); column = 1) {
            const bool good = network_digits(line.words[at])
                                  ? read_network(line.words, at, column)
                                  : read_instruction(line.words, at, column);
            if (!good) return;
        }
        ListingItem& item = items_.back();
        if (item.is_network) {
            add_network_comment(comment, line.comment_at);
            comment_is_open_ = line.has_comment;
        } else {
            append_comment(item.instruction.comment, comment);
        }
    }

    /// Appends to the comment of the last network. Print that has two columns side by side may have
    /// the beginning of a network of the right one behind the comment of the left one.
    void add_network_comment(std::string_view comment, Location where) {
        std::vector<std::uint32_t> behind;
        for (;;) {
            const std::size_t blank = comment.find_last_of(' ');
            if (blank == std::string_view::npos) break;
            const auto digits = network_digits({comment.substr(blank + 1), false, where});
            if (!digits || digits->empty()) break;
            behind.insert(behind.begin(), number_of(*digits));
            comment = comment.substr(0, comment.find_last_not_of(' ', blank) + 1);
        }
        append_comment(items_.back().network.comment, comment);
        for (const std::uint32_t number : behind) add_network(number, where, 1);
    }

    bool read_network(const std::vector<ListingWord>& words, std::size_t& at, std::uint8_t column) {
        const Location where = words[at].where;
        std::string_view digits = *network_digits(words[at++]);
        if (digits.empty() && at + 1 == words.size() && is_offset(words[at])) {
            digits = words[at++].text;
        }
        add_network(digits.empty() ? last_number_ + 1 : number_of(digits), where, column);
        if (at < words.size() && !begins_second_item(words, at)) {
            error(code::unexpected_token, words[at].where, say::only_comment_after_network());
            return false;
        }
        return true;
    }

    void add_network(std::uint32_t number, Location where, std::uint8_t column) {
        ListingItem item;
        item.is_network = true;
        item.network.number = number;
        item.network.where = where;
        item.column = column;
        items_.push_back(std::move(item));
        last_number_ = number;
    }

    /// Whether a word behind a whole item begins one of a second column.
    static bool begins_second_item(const std::vector<ListingWord>& words, std::size_t at) {
        if (network_digits(words[at])) return true;
        return is_offset(words[at]) && at + 1 < words.size() &&
               instruction_named(words[at + 1].text);
    }

    bool read_instruction(const std::vector<ListingWord>& words, std::size_t& at,
                          std::uint8_t column) {
        ListingItem item;
        item.column = column;
        if (is_offset(words[at]) && at + 1 < words.size()) {
            item.instruction.printed_offset = number_of(words[at++].text);
        }
        const ListingWord& mnemonic = words[at++];
        item.instruction.where = mnemonic.where;
        const auto named = mnemonic.quoted ? std::nullopt : instruction_named(mnemonic.text);
        if (!named) {
            report_unknown_instruction(mnemonic);
            return false;
        }
        item.instruction.operation = named->row->operation;
        item.instruction.width = named->row->width;
        item.instruction.compare = named->compare;
        const std::size_t wanted = named->row->operand_count();
        for (std::size_t i = 0; i < wanted; ++i, ++at) {
            if (at == words.size()) {
                error(code::bad_operand, mnemonic.where,
                      i == 0 ? say::operands_missing(wanted, mnemonic.text)
                             : say::some_operands_missing(i, mnemonic.text, wanted));
                return false;
            }
            item.instruction.operands.push_back(read_operand(words[at]));
        }
        if (at < words.size() && !begins_second_item(words, at)) {
            error(code::unexpected_token, words[at].where,
                  say::one_operand_too_many(wanted, mnemonic.text, shortened(words[at].text)));
            return false;
        }
        items_.push_back(std::move(item));
        return true;
    }

    void report_unknown_instruction(const ListingWord& word) {
        error(code::unknown_instruction, word.where,
              unknown_instruction_message(word.text, suggests()));
    }

    bool suggests() { return suggestion_count_++ < most_suggestions; }

    Operand read_operand(const ListingWord& word) {
        Operand operand;
        if (!word.quoted) {
            if (const auto parsed = parse_operand(word.text)) return *parsed;
            if (word.text == "KI" || word.text == "Kl") {
                note_lenient(say::read_as_k1(word.text), word.where);
                operand.area = Area::constant;
                operand.address = 1;
                return operand;
            }
        }
        if (options_.io != nullptr) {
            if (const Operand* assigned = options_.io->operand_of(word.text)) return *assigned;
        }
        error(code::bad_operand, word.where,
              unknown_operand_message(word.text, word.quoted, options_.io, suggests()));
        operand.area = Area::text;
        operand.symbol = word.text;
        return operand;
    }

    struct Lenient {
        Localized what;
        Location first;
        std::size_t count = 0;
    };

    const ReadingOptions& options_;
    Diagnostics& diagnostics_;
    Listing listing_;
    std::vector<ListingItem> items_;
    std::map<std::string, Lenient> lenient_;  ///< by what it says in English
    std::uint32_t last_number_ = 0;
    bool comment_is_open_ = false;  ///< the line before ended in the comment of a network
    std::size_t suggestion_count_ = 0;
};

}  // namespace

std::optional<Listing> parse_listing(const SourceFile& source, const ReadingOptions& options,
                                     Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    std::string_view text = source.text;
    if (!check_utf8(text, diagnostics)) return std::nullopt;
    text.remove_prefix(byte_order_mark_size(text));
    ListingReader reader(options, diagnostics);
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, length), number);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    Listing listing = reader.finish();
    const bool is_whole = diagnostics.error_count() == errors_before;
    for (const OffsetDeviation& deviation : offset_deviations(listing)) {
        if (!is_whole) break;  // sizes are missing
        diagnostics.warning(code::bad_offset, deviation.where,
                            say::offset_deviates(deviation.printed, deviation.computed));
    }
    if (!options.is_fragment) check_listing(listing, options.cpu, diagnostics);
    diagnostics.sort_by_place();
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return listing;
}

}  // namespace grafwire::s7
