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
    return {{},
            {.name = "any", .kind = DelayModel::Kind::any},
            {.name = "any-wire", .kind = DelayModel::Kind::any_wire}};
}

/// Over both edges of all inverters, ANDs, ORs, NANDs and NORs with up to four inputs.
DelayBand band_of_gates(const PartFamily& family) {
    constexpr std::size_t most_inputs = 4;
    DelayBand all{longest, 0};
    for (const PartFigures& part : family.parts) {
        const bool is_other = row_of(part.type).has_memory || part.type == CellType::xor_gate;
        if (is_other || part.inputs > most_inputs) continue;
        const EdgeBands bands = *bands_of(family, part.type, part.inputs);
        all.min = std::min({all.min, bands.rise.min, bands.fall.min});
        all.max = std::max({all.max, bands.rise.max, bands.fall.max});
    }
    return all;
}

}  // namespace

std::optional<DelayModel> delay_model_of(std::string_view text) {
    for (DelayModel& model : named_models()) {
        if (model.name == text) return std::move(model);
    }
    if (const PartFamily* family = part_family_named(text)) {
        return DelayModel{.name = std::string(text),
                          .kind = DelayModel::Kind::bounded,
                          .gate = band_of_gates(*family),
                          .family = family};
    }
    return read_bounds(text);
}

/// That each family has a typical one as well is left to the help.
std::vector<std::string_view> delay_model_names() {
    std::vector<std::string_view> names{"unit", "MIN..MAX", "any", "any-wire"};
    for (const PartFamily& family : part_families()) {
        if (!family.is_typical) names.push_back(family.name);
    }
    return names;
}

CellDelays cell_delays(const Netlist& netlist, const DelayModel& model) {
    CellDelays delays;
    delays.rise.reserve(netlist.cells.size());
    delays.fall.reserve(netlist.cells.size());
    for (const Cell& cell : netlist.cells) {
        const EdgeBands bands = model.bands(cell.type, cell.pin_count);
        delays.rise.push_back(bands.rise.min);
        delays.fall.push_back(bands.fall.min);
    }
    return delays;
}

}  // namespace grafwire
