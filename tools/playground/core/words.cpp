// What an editor has to know of the language, and what lists of options have to offer.

#include "core/requests.h"
#include "draw/scene.h"
#include "grafcet/lexer.h"
#include "netlist/delay_model.h"
#include "netlist/styles/styles.h"
#include "workflow/chart.h"
#include "workflow/drawings.h"
#include "workflow/schematics.h"

namespace grafwire::playground {

namespace {

/// One spelling of each reserved word in either language, as in the canonical layout.
Json keywords() {
    Json list = Json::array();
    const auto last = static_cast<std::size_t>(TokenKind::kw_xor);
    for (auto i = static_cast<std::size_t>(TokenKind::kw_activation); i <= last; ++i) {
        const auto kind = static_cast<TokenKind>(i);
        list.push_back({{"en", keyword_in(Language::english, kind)},
                        {"fr", keyword_in(Language::french, kind)}});
    }
    return list;
}

/// An operator: the signs that stand for it, and its word.
struct OperatorRow {
    std::string_view name;
    std::vector<std::string_view> symbols;
    TokenKind word;
};

Json operators() {
    const OperatorRow rows[] = {
        {"and", {".", "*", "&"}, TokenKind::kw_and}, {"or", {"+", "|"}, TokenKind::kw_or},
        {"xor", {"⊕"}, TokenKind::kw_xor},           {"not", {"/", "!"}, TokenKind::kw_not},
        {"rise", {"↑"}, TokenKind::kw_rise},         {"fall", {"↓"}, TokenKind::kw_fall},
    };
    Json list = Json::array();
    for (const OperatorRow& row : rows) {
        const std::string_view english = keyword_in(Language::english, row.word);
        const std::string_view french = keyword_in(Language::french, row.word);
        std::vector<std::string_view> words = {english};
        if (french != english) words.push_back(french);
        list.push_back({{"name", row.name}, {"symbols", row.symbols}, {"words", words}});
    }
    return list;
}

template <typename Rows>
Json names_of(const Rows& rows) {
    Json list = Json::array();
    for (const auto& row : rows) list.push_back(row.name);
    return list;
}

}  // namespace

Json answer_words(const Arguments& arguments, const Asked&) {
    Json styles = Json::array();
    for (const StyleRow& row : style_table) {
        styles.push_back({{"name", row.name},
                          {"description", row.description.in(arguments.language())},
                          {"clocked", row.style == Style::clocked}});
    }
    return Json{{"keywords", keywords()},
                {"operators", operators()},
                {"modes", {"Init", "AUdur", "AUdoux"}},
                {"styles", styles},
                {"cdx", names_of(cdx_table)},
                {"delays", {DelayModel().name, "1..2", "1..4", "any"}},
                {"notations", names_of(notation_table)},
                {"papers", names_of(papers)},
                {"symbols", names_of(gate_shapes_table)},
                {"equation_formats", names_of(equation_format_table)},
                {"changes", {"one", "many"}}};
}

}  // namespace grafwire::playground
