#include <doctest/doctest.h>

#include "formats/sample_netlists.h"
#include "formats/shared/net_spelling.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string percent_escaped(std::string_view name, bool (*is_unsafe)(char)) {
    std::string out;
    append_percent_escaped(out, name, is_unsafe);
    return out;
}

bool nothing(char) {
    return false;
}

void spell_plain(std::string& out, std::string_view name) {
    out += name;
}

}  // namespace

TEST_CASE("what is escaped with percent signs comes back, whatever is unsafe") {
    std::string every_byte = "a";
    for (int byte = 255; byte >= 0; --byte) every_byte += static_cast<char>(byte);
    for (const std::string& name : {every_byte, std::string("%"), std::string("100%25%"),
                                    std::string("%%20"), std::string("été%2"), std::string()}) {
        for (const auto is_unsafe : {nothing, is_control_or_blank, is_percent_escaped}) {
            const std::string escaped = percent_escaped(name, is_unsafe);
            CHECK(percent_decoded(escaped) == name);
            for (const char c : escaped) CHECK((c == '%' || !is_unsafe(c)));
        }
    }
}

TEST_CASE("only what some writer escapes is decoded") {
    CHECK(percent_decoded("a%20b%25c%2A") == "a b%c*");
    CHECK(percent_decoded("%41%e9%2a%C3%8") == "%41%e9%2a%C3%8");
    CHECK(percent_decoded("%2") == "%2");
    CHECK(percent_decoded("%") == "%");
}

TEST_CASE("names that a language cannot tell apart get numbers, ports first") {
    NetlistMaker maker("names");
    maker.net("X1");
    for (const char* name : {"x1", "entity", "a"}) maker.input(name);
    maker.cell(CellType::inverter, "X1", {"a"}).cell(CellType::inverter, "A", {"a"});
    const Netlist netlist = maker.output("A").make();
    const auto spelled = [&](const NetSpelling& spelling) {
        std::string all;
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            all += std::string(spelling[static_cast<NetId>(i)]) + ' ';
        }
        CHECK(spelling.length() == all.size() - netlist.net_count());
        return all;
    };
    const auto is_reserved = [](std::string_view word) { return word == "entity"; };
    CHECK(spelled(NetSpelling(netlist, spell_plain)) == "X1 x1 entity a A ");
    CHECK(spelled(NetSpelling(netlist, spell_plain, SafeNames(true, is_reserved))) ==
          "X1 x1 entity_2 a A ");
    CHECK(spelled(NetSpelling(netlist, spell_plain, SafeNames(false, is_reserved))) ==
          "X1_2 x1 entity_2 a A_2 ");
}
