#include "core/arguments.h"

#include <algorithm>

namespace grafwire::playground {

Arguments::Arguments(const Json& members) : members_(members) {
    if (!members.is_object()) fault_ = "args";
}

const Json* Arguments::find(std::string_view name, bool (Json::*is_right)() const noexcept) const {
    if (!members_.is_object()) return nullptr;
    const auto found = members_.find(std::string(name));
    if (found == members_.end() || found->is_null()) return nullptr;
    if ((*found.*is_right)()) return &*found;
    if (fault_.empty()) fault_ = name;
    return nullptr;
}

bool Arguments::has(std::string_view name) const {
    if (!members_.is_object()) return false;
    const auto found = members_.find(std::string(name));
    return found != members_.end() && !found->is_null();
}

std::string Arguments::text(std::string_view name, std::string_view otherwise) const {
    const Json* found = find(name, &Json::is_string);
    return found != nullptr ? found->get<std::string>() : std::string(otherwise);
}

bool Arguments::flag(std::string_view name, bool otherwise) const {
    const Json* found = find(name, &Json::is_boolean);
    return found != nullptr ? found->get<bool>() : otherwise;
}

std::optional<double> Arguments::number(std::string_view name) const {
    const Json* found = find(name, &Json::is_number);
    return found != nullptr ? std::optional(found->get<double>()) : std::nullopt;
}

std::uint64_t Arguments::count(std::string_view name) const {
    constexpr double most = 9007199254740992.0;  // every whole number up to it is a double
    return static_cast<std::uint64_t>(std::clamp(number(name).value_or(0), 0.0, most));
}

std::vector<std::string> Arguments::texts(std::string_view name) const {
    std::vector<std::string> result;
    const Json* found = find(name, &Json::is_array);
    if (found == nullptr) return result;
    for (const Json& item : *found) {
        if (item.is_string()) {
            result.push_back(item.get<std::string>());
        } else if (fault_.empty()) {
            fault_ = name;
        }
    }
    return result;
}

const Json& Arguments::object(std::string_view name) const {
    static const Json none = Json::object();
    const Json* found = find(name, &Json::is_object);
    return found != nullptr ? *found : none;
}

Language Arguments::language() const {
    return text("lang", "en") == "fr" ? Language::french : Language::english;
}

}  // namespace grafwire::playground
