// pugixml tells where a node stands as an offset in the text; lines are found by bisection over
// their beginnings, which costs nothing until there is something to report.

#include "plcopen/source.h"

#include <algorithm>

#include "plcopen/messages.h"
#include "text/utf8.h"

namespace grafwire::plcopen {

Source::Source(const SourceFile& source, Code code, Diagnostics& diagnostics)
    : text_(source.text), code_(code), diagnostics_(diagnostics) {
    lines_.push_back(0);
    for (std::size_t at = 0; at < text_.size(); ++at) {
        if (text_[at] == '\n') lines_.push_back(at + 1);
    }
    if (!check_utf8(text_, diagnostics)) return;
    const pugi::xml_parse_result result = document_.load_buffer(
        text_.data(), text_.size(), pugi::parse_default | pugi::parse_ws_pcdata_single,
        pugi::encoding_utf8);
    if (!result) {
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
        error(place_at(at), messages::plcopen::no_xml(result.description()));
        return;
    }
    is_read_ = true;
}

Location Source::place_at(std::size_t byte) const {
    byte = std::min(byte, text_.size());
    const auto next = std::upper_bound(lines_.begin(), lines_.end(), byte);
    const std::size_t begin = *(next - 1);
    const std::string_view before = std::string_view(text_).substr(begin, byte - begin);
    return {static_cast<std::uint32_t>(next - lines_.begin()),
            static_cast<std::uint32_t>(count_code_points(before) + 1)};
}

Location Source::place_of(pugi::xml_node node) const {
    const std::ptrdiff_t offset = node.offset_debug();
    if (offset < 1) return {};
    return place_at(static_cast<std::size_t>(offset) - 1);  // at the `<` before the name
}

void Source::check_name(std::string_view name, pugi::xml_node node) const {
    if (find_control(name) == std::string_view::npos) return;
    diagnostics_.error(code::unexpected_character, place_of(node), control_in_name_message(name));
}

std::string_view local_name(pugi::xml_node node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_named(pugi::xml_node parent, std::string_view name) {
    for (const pugi::xml_node child : parent.children()) {
        if (local_name(child) == name) return child;
    }
    return {};
}

std::string text_of(pugi::xml_node node) {
    struct Walker : pugi::xml_tree_walker {
        std::string text;
        bool for_each(pugi::xml_node& inner) override {
            const bool is_text =
                inner.type() == pugi::node_pcdata || inner.type() == pugi::node_cdata;
            if (is_text) text += std::string(inner.value()) + " ";
            return true;
        }
    } walker;
    node.traverse(walker);
    std::string folded;
    for (const char c : walker.text) {
        const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!blank) {
            folded += c;
        } else if (!folded.empty() && folded.back() != ' ') {
            folded += ' ';
        }
    }
    if (!folded.empty() && folded.back() == ' ') folded.pop_back();
    return visible(folded);
}

}  // namespace grafwire::plcopen
