// A table of assignment goes by lines, as stimuli do: after an error the reader goes on with the
// next line, so that all errors are reported in one go.

#include "s7/addresses/io_assignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grafcet/lexer.h"
#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "text/utf8.h"
#include "trace/line_cursor.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_addresses;

/// The bits an operand covers: of a byte, word or double word all of them, whatever their order; a
/// timer or counter counts as one.
std::pair<std::int64_t, std::int64_t> bits_of(const Operand& operand) {
    const std::int64_t first = std::int64_t{operand.address} * 8;
    switch (operand.width) {
        case Width::bit:
            return {first + operand.bit, first + operand.bit + 1};
        case Width::byte:
            return {first, first + 8};
        case Width::word:
            return {first, first + 16};
        case Width::dword:
            return {first, first + 32};
    }
    return {first, first};
}

class AssignmentReader {
  public:
    explicit AssignmentReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void read_line(std::string_view line, std::uint32_t number) {
        LineCursor cursor(line, number);
        cursor.skip_blanks();
        if (cursor.at_end()) return;
        const Location where = cursor.here();
        const auto operand = read_address(cursor);
        if (!operand) return;
        cursor.skip_blanks();
        if (!cursor.skip_if('=')) {
            error(code::unexpected_token, cursor.here(), say::name_expected_after_address());
            return;
        }
        cursor.skip_blanks();
        const Location name_at = cursor.here();
        const auto name = read_name(cursor);
        if (!name) return;
        cursor.skip_blanks();
        if (!cursor.at_end()) {
            error(code::unexpected_token, cursor.here(), say::only_comment_after_name());
            return;
        }
        add({*operand, std::string(*name), where}, name_at);
    }

    IoAssignment finish() { return std::move(assignment_); }

  private:
    Diagnostic& error(Code code, Location where, Localized message) {
        return diagnostics_.error(code, where, std::move(message));
    }

    std::optional<Operand> read_address(LineCursor& cursor) {
        const Location where = cursor.here();
        const std::string_view text = cursor.take_until_blank('=');
        auto operand = parse_operand(text);
        if (operand && operand->area != Area::constant) return operand;
        error(code::bad_address, where, say::not_an_address(shortened(text)));
        return std::nullopt;
    }

    /// A word, a text in quotes, or a transition's label in parentheses.
    std::optional<std::string_view> read_name(LineCursor& cursor) {
        const Location where = cursor.here();
        const std::string_view rest = cursor.rest();
        const bool quoted = rest.starts_with('"');
        if (quoted || rest.starts_with('(')) {
            const std::size_t end = rest.find(quoted ? '"' : ')', 1);
            if (end == std::string_view::npos) {
                error(code::unterminated_text, where, say::unterminated_name());
                return std::nullopt;
            }
            cursor.skip(end + 1);
            const std::string_view name =
                quoted ? rest.substr(1, end - 1) : rest.substr(0, end + 1);
            if (find_control(name) == std::string_view::npos) return name;
            error(code::unexpected_character, where, control_in_name_message(name));
            return std::nullopt;
        }
        const std::string_view name = cursor.take_word();
        if (name.empty()) {
            error(code::unexpected_token, where, say::name_expected());
            return std::nullopt;
        }
        return name;
    }

    void add(IoAssignment::Entry entry, Location name_at) {
        entry.name = normalised(entry.name);  // charts have their names so
        const auto [named, is_new] = by_name_.emplace(entry.name, name_at);
        if (!is_new) {
            error(code::duplicate_name, name_at, say::has_an_address(shortened(entry.name)))
                .notes.push_back({named->second, say::here()});
            return;
        }
        const auto [first, last] = bits_of(entry.operand);
        for (std::int64_t bit = first; bit < last; ++bit) {
            const auto [taken, is_free] =
                by_bit_.emplace(std::pair{entry.operand.area, bit}, entry.where);
            if (is_free) continue;
            error(code::duplicate_name, entry.where,
                  say::address_taken(write_operand(entry.operand, Mnemonics::simatic)))
                .notes.push_back({taken->second, say::by_this_address()});
            return;
        }
        assignment_.entries.push_back(std::move(entry));
    }

    Diagnostics& diagnostics_;
    IoAssignment assignment_;
    std::map<std::string, Location> by_name_;
    std::map<std::pair<Area, std::int64_t>, Location> by_bit_;
};

/// Whether a name can stand without quotes.
bool is_plain(std::string_view name) {
    if (name.size() > 2 && name.front() == '(' && name.find(')') == name.size() - 1) return true;
    LineCursor cursor(name, 1);
    return !name.empty() && cursor.take_word().size() == name.size();
}

}  // namespace

const Operand* IoAssignment::operand_of(std::string_view name) const {
    for (const Entry& entry : entries) {
        if (entry.name == name) return &entry.operand;
    }
    return nullptr;
}

std::optional<IoAssignment> parse_io_assignment(const SourceFile& source,
                                                Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    std::string_view text = source.text;
    if (!check_utf8(text, diagnostics)) return std::nullopt;
    text.remove_prefix(byte_order_mark_size(text));
    AssignmentReader reader(diagnostics);
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, length), number);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return reader.finish();
}

std::string write_io_assignment(const IoAssignment& assignment, Mnemonics mnemonics) {
    std::string out;
    for (const IoAssignment::Entry& entry : assignment.entries) {
        const bool plain = is_plain(entry.name);
        out += fmt::format("{:<6} = {}{}{}\n", write_operand(entry.operand, mnemonics),
                           plain ? "" : "\"", entry.name, plain ? "" : "\"");
    }
    return out;
}

}  // namespace grafwire::s7
