// The delay models that can be asked for. Bounds are read with up to three digits after the point,
// which is down to a picosecond.

#include "netlist/delay_model.h"

#include <array>
#include <charconv>

namespace grafwire {

namespace {

constexpr Time longest = second;

/// A positive number of nanoseconds.
std::optional<Time> read_nanoseconds(std::string_view text) {
    const std::size_t point = text.find('.');
    std::string digits(text.substr(0, point));
    std::string_view fraction = point == std::string_view::npos ? "" : text.substr(point + 1);
    if (digits.empty() || fraction.size() > 3 ||
        (point != std::string_view::npos && fraction.empty())) {
        return std::nullopt;
    }
    digits += fraction;
    digits.append(3 - fraction.size(), '0');
    Time time = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), time);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size();
    if (!is_number || digits[0] == '-' || time <= 0 || time > longest) return std::nullopt;
    return time;
}

std::optional<DelayModel> read_bounds(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const auto min = read_nanoseconds(text.substr(0, dots));
    const auto max = read_nanoseconds(text.substr(dots + 2));
    if (!min || !max || *min > *max) return std::nullopt;
    return DelayModel{
        .name = std::string(text), .kind = DelayModel::Kind::bounded, .gate = {*min, *max}};
}

std::vector<DelayModel> named_models() {
    return {{}, {.name = "any", .kind = DelayModel::Kind::any}};
}

}  // namespace

std::optional<DelayModel> delay_model_of(std::string_view text) {
    for (DelayModel& model : named_models()) {
        if (model.name == text) return std::move(model);
    }
    return read_bounds(text);
}

std::vector<std::string_view> delay_model_names() {
    return {"unit", "MIN..MAX", "any"};
}

CellDelays cell_delays(const Netlist& netlist, const DelayModel& model) {
    CellDelays delays;
    delays.rise.reserve(netlist.cells.size());
    for (const Cell& cell : netlist.cells) delays.rise.push_back(model.band(cell.type).min);
    delays.fall = delays.rise;
    return delays;
}

}  // namespace grafwire
