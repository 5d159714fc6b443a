#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "grafcet/name_table.h"

namespace grafwire::testing {

namespace {

/// Names with long common beginnings, with common ends, of one character, and the empty one.
std::vector<std::string> many_names() {
    std::vector<std::string> names = {""};
    for (char c = ' '; c <= '~'; ++c) names.emplace_back(1, c);
    for (int i = 0; i < 5'000; ++i) {
        names.push_back("step" + std::to_string(i));
        names.push_back(std::to_string(i) + "é");
    }
    return names;
}

}  // namespace

TEST_CASE("every name is found again, and no other") {
    const std::vector<std::string> names = many_names();
    for (const bool with_room : {false, true}) {
        NameTable<std::size_t> table;
        CHECK(table.find("") == nullptr);
        if (with_room) table.reserve(names.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            CHECK(table.find(names[i]) == nullptr);
            const auto added = table.add(names[i], i);
            CHECK(added.is_new);
            CHECK(added.value == i);
        }
        for (std::size_t i = 0; i < names.size(); ++i) {
            const std::size_t* found = table.find(names[i]);
            REQUIRE(found != nullptr);
            CHECK(*found == i);
        }
        CHECK(table.find("step5000") == nullptr);
        CHECK(table.find("ste") == nullptr);
    }
}

TEST_CASE("of a name added twice the first value counts") {
    NameTable<int> table;
    CHECK(table.add("a", 1).is_new);
    const auto again = table.add("a", 2);
    CHECK_FALSE(again.is_new);
    CHECK(again.value == 1);
    CHECK(*table.find("a") == 1);
}

}  // namespace grafwire::testing
