#include "draw/describe_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "draw/messages.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace say = messages::draw;

/// A kind of owners whose names are told, and their fact that is the name.
struct Told {
    std::string_view kind;
    std::string_view fact;
    const CountedMessage<std::string>& sentence;
};
constexpr Told all_told[] = {
    {"step", "step", say::shown_steps},
    {"macro-step", "macro", say::shown_macro_steps},
    {"transition", "transition", say::shown_transitions},
    {"module", "module", say::shown_modules},
    {"signal", "signal", say::shown_signals},
};

bool has_class(const Owner& owner, std::string_view name) {
    return fmt::format(" {} ", owner.kind).find(fmt::format(" {} ", name)) != std::string::npos;
}

/// The kind is the first class.
bool is_of_kind(const Owner& owner, std::string_view kind) {
    return owner.kind.substr(0, owner.kind.find(' ')) == kind;
}

/// Owners that have a shape on the sheet, in their order.
std::vector<const Owner*> shown_owners(const Scene& scene) {
    std::vector<bool> is_shown(scene.owners.size());
    for (const Shape& shape : scene.shapes) is_shown[index_of(shape.owner)] = true;
    std::vector<const Owner*> owners;
    for (std::size_t i = 0; i < is_shown.size(); ++i) {
        if (is_shown[i]) owners.push_back(&scene.owners[scene.owners.id_at(i)]);
    }
    return owners;
}

/// The text above the sheet.
std::string heading_of(const Scene& scene) {
    for (const Shape& shape : scene.shapes) {
        const auto* label = std::get_if<Label>(&shape.form);
        if (label != nullptr && is_of_kind(scene.owners[shape.owner], "title")) {
            std::string text;
            for (const TextRun& run : label->text) text += run.text;
            return text;
        }
    }
    return {};
}

}  // namespace

std::string describe_sheet(const Sheet& sheet, Language language) {
    const std::vector<const Owner*> owners = shown_owners(sheet.scene);
    std::string description = heading_of(sheet.scene) + '.';
    const auto tell = [&](const CountedMessage<std::string>& sentence, const Told& told,
                          std::string_view only_of_class) {
        std::vector<std::string_view> names;
        std::unordered_set<std::string_view> seen;
        for (const Owner* owner : owners) {
            if (!is_of_kind(*owner, told.kind) || !has_class(*owner, only_of_class)) continue;
            for (const auto& [fact, value] : owner->facts) {
                if (fact == told.fact && seen.insert(value).second) names.push_back(value);
            }
        }
        if (names.empty()) return;
        description += ' ' + sentence.in(language, names.size(), joined(names, ", "));
    };
    for (const Told& told : all_told) tell(told.sentence, told, told.kind);
    tell(say::shown_active_steps, all_told[0], "active");
    return description;
}

}  // namespace grafwire
