// The parser is that of nlohmann/json, as a stream of events. Its own tree either sorts the members
// of objects or takes time that grows with the square of their number; a netlist is one large
// object whose order matters.

#include "formats/yosys/json_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "formats/shared/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::size_t deepest = 20;

/// Walks through a text and keeps the place of the last character read. The parser reads one
/// character after the other and looks ahead by none where an object begins, so the place is that
/// of its bracket.
class PlaceCounter {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    PlaceCounter(const char* next, Location& last) : next_(next), last_(&last) {}
    const char& operator*() const { return *next_; }
    PlaceCounter& operator++() {
        if (*next_ == '\n') {
            ++last_->line;
            last_->column = 0;
        } else if (begins_character(*next_)) {
            ++last_->column;
        }
        ++next_;
        return *this;
    }
    bool operator==(const PlaceCounter& other) const { return next_ == other.next_; }
    bool operator!=(const PlaceCounter& other) const { return next_ != other.next_; }

  private:
    const char* next_;
    Location* last_;
};

/// Makes the tree from the events of the parser: `open_` leads from the root to the value that is
/// being read.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
  public:
    JsonValue root;
    bool too_deep = false;
    std::size_t error_position = 0;
    std::string error_message;
    Location where{1, 0};  ///< the last character read

    bool null() override { return add(JsonValue::Kind::null, {}); }
    bool boolean(bool value) override {
        return add(JsonValue::Kind::boolean, value ? "true" : "false");
    }
    bool number_integer(std::int64_t value) override {
        return add(JsonValue::Kind::number, std::to_string(value));
    }
    bool number_unsigned(std::uint64_t value) override {
        return add(JsonValue::Kind::number, std::to_string(value));
    }
    bool number_float(double, const std::string& written) override {
        return add(JsonValue::Kind::number, written);
    }
    bool string(std::string& value) override {
        return add(JsonValue::Kind::string, std::move(value));
    }
    bool binary(nlohmann::json::binary_t&) override { return false; }
    bool key(std::string& name) override {
        key_ = std::move(name);
        return true;
    }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::json::exception& error) override {
        error_position = position;
        error_message = error.what();
        return false;
    }

  private:
    /// Where the next value goes: into the array, or under the key that was read last.
    JsonValue& place() {
        if (open_.empty()) return root;
        JsonValue& parent = *open_.back();
        if (parent.kind == JsonValue::Kind::array) return parent.items.emplace_back();
        parent.members.push_back({std::move(key_), JsonValue()});
        return parent.members.back().value;
    }
    bool add(JsonValue::Kind kind, std::string text) {
        JsonValue& value = place();
        value.kind = kind;
        value.text = std::move(text);
        return true;
    }
    bool open(JsonValue::Kind kind) {
        if (open_.size() == deepest) {
            too_deep = true;
            return false;
        }
        JsonValue& value = place();
        value.kind = kind;
        value.where = where;
        // A parent gets no further members while its child is open, so the pointer stays good.
        open_.push_back(&value);
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    std::vector<JsonValue*> open_;
    std::string key_;
};

/// The place of the byte before `position` (the parser counts those it has read).
Location location_of(std::string_view text, std::size_t position) {
    Location where{1, 1};
    const std::size_t end = std::min(position == 0 ? 0 : position - 1, text.size());
    for (std::size_t i = 0; i < end; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte == '\n') {
            ++where.line;
            where.column = 1;
        } else if (i + 1 == text.size() || begins_character(text[i + 1])) {
            ++where.column;
        }
    }
    return where;
}

/// What the library says, without its number and its own account of the place.
std::string reason_in(const std::string& message) {
    const std::size_t bracket = message.find(": ");
    std::string reason = bracket == std::string::npos ? message : message.substr(bracket + 2);
    if (const std::size_t last = reason.find("; last read"); last != std::string::npos) {
        reason.resize(last);
    }
    return reason;
}

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
    for (const auto& [key, value] : members) {
        if (key == name) return &value;
    }
    return nullptr;
}

std::optional<JsonValue> parse_json(std::string_view text, Diagnostics& diagnostics) {
    if (!check_utf8(text, diagnostics)) return std::nullopt;
    TreeBuilder builder;
    const PlaceCounter begin(text.data(), builder.where);
    const PlaceCounter end(text.data() + text.size(), builder.where);
    if (nlohmann::json::sax_parse(begin, end, &builder)) return std::move(builder.root);
    if (builder.too_deep) {
        diagnostics.error(code::nested_too_deep, builder.where,
                          messages::formats::nested_too_deep(deepest));
    } else {
        diagnostics.error(code::bad_netlist, location_of(text, builder.error_position),
                          messages::formats::not_json(reason_in(builder.error_message)));
    }
    return std::nullopt;
}

}  // namespace grafwire
