// A ladder diagram out of a PLCopen project, in the order of its steps: the program is found, its
// variables are read, the elements of its body, then the networks that they make. Variables
// and elements are both read before any error ends it, so that one run tells all of theirs.

#include "plcopen/read_ladder.h"

#include <algorithm>

#include "iec/identifiers.h"
#include "plcopen/ladder_networks.h"
#include "plcopen/messages.h"
#include "text/utf8.h"

namespace grafwire::plcopen {

namespace {

/// The pou to be read, with its LD body; null where that is not clear, which has been reported.
pugi::xml_node find_program(const Source& source, std::string_view wanted) {
    const pugi::xml_node root = source.root();
    if (local_name(root) != "project") {
        source.error(root, messages::plcopen::no_project());
        return {};
    }
    std::vector<pugi::xml_node> found;
    std::string names;
    for (const pugi::xml_node pou : child_named(child_named(root, "types"), "pous").children()) {
        if (!child_named(child_named(pou, "body"), "LD")) continue;
        const std::string_view name = pou.attribute("name").as_string();
        if (!wanted.empty() && iec::capitals(name) != iec::capitals(wanted)) continue;
        found.push_back(pou);
        names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name);
    }
    if (found.size() == 1) return found.front();
    if (found.empty()) {
        source.error(root, wanted.empty() ? messages::plcopen::no_ladder()
                                          : messages::plcopen::no_ladder_named(shortened(wanted)));
    } else {
        source.error(root, messages::plcopen::several_ladders(names));
    }
    return {};
}

/// The comments between two networks belong to the lower one: the last is its own, one before that
/// the title of what begins there.
void add_comments(const LadderElements& elements, ladder::Ladder& ladder) {
    std::vector<std::pair<int, const Element*>> comments;
    std::vector<int> tops(elements.network_count(), 0);
    std::vector<bool> seen(elements.network_count(), false);
    for (const Element& element : elements.all()) {
        if (element.kind == Element::Kind::comment) {
            comments.emplace_back(element.y, &element);
            continue;
        }
        const bool places =
            element.kind == Element::Kind::contact || element.kind == Element::Kind::coil ||
            element.kind == Element::Kind::block || element.kind == Element::Kind::out_variable;
        if (!places) continue;
        int& top = tops[element.network];
        top = seen[element.network] ? std::min(top, element.y) : element.y;
        seen[element.network] = true;
    }
    std::stable_sort(comments.begin(), comments.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> own(tops.size());
    std::vector<std::string> headings(tops.size());
    std::size_t next = 0;
    for (std::size_t network = 0; network < tops.size(); ++network) {
        for (; next < comments.size() && comments[next].first <= tops[network]; ++next) {
            if (headings[network].empty()) headings[network] = own[network];
            own[network] = comments[next].second->text;
        }
    }
    std::vector<bool> begun(tops.size(), false);
    for (ladder::Rung& rung : ladder.rungs) {
        const std::size_t network = rung.number - 1;
        rung.comment = own[network];
        if (!begun[network]) rung.heading = headings[network];
        begun[network] = true;
    }
}

}  // namespace

std::optional<ladder::Ladder> read_ladder(const SourceFile& file, Diagnostics& diagnostics,
                                          std::string_view program) {
    const Source source(file, code::bad_ladder, diagnostics);
    if (!source.is_read()) return std::nullopt;
    const pugi::xml_node pou = find_program(source, program);
    if (!pou) return std::nullopt;
    ladder::Ladder ladder;
    ladder.name = pou.attribute("name").as_string();
    source.check_name(ladder.name, pou);
    LadderVariables variables(source, ladder);
    variables.read(source.root(), pou);
    const LadderElements elements(source, child_named(child_named(pou, "body"), "LD"));
    if (diagnostics.has_errors()) return std::nullopt;
    ladder.declared = ladder.variables.size();
    LadderNetworks(source, elements, variables, ladder).read();
    if (diagnostics.has_errors()) return std::nullopt;
    add_comments(elements, ladder);
    return ladder;
}

}  // namespace grafwire::plcopen
