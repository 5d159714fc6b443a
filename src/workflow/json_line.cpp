#include "workflow/json_line.h"

#include <nlohmann/json.hpp>

namespace grafwire {

std::string json_line(const std::string& json, std::string_view file) {
    using Json = nlohmann::ordered_json;
    const Json whole = Json::parse(json, nullptr, false);
    Json line = Json::object();
    if (!file.empty() && !whole.contains("file")) line["file"] = file;
    line.update(whole);
    return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grafwire
