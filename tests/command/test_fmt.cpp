// grafwire fmt: what it writes where, and the exit status.

#include <doctest/doctest.h>

#include <filesystem>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Names = std::vector<std::string>;

constexpr const char* crowded = "input a # x\ngraph G{initial step 0 0->0:a et a}";
constexpr const char* english = "input a  # x\ngraph G {\n  initial 0\n  0 -> 0 : a . a\n}\n";
constexpr const char* french =
    "entrée a  # x\ngraphe G {\n  étape initiale 0\n  0 -> 0 : a . a\n}\n";
constexpr const char* wrong = "graph G { initial 0\n 0 -> 1 : 1 }\n";

}  // namespace

TEST_CASE("one file goes to standard output, with its keywords in the language of --lang") {
    const ScratchFolder folder;
    const std::string file = folder.file("a.grafcet", crowded);
    const Ran ran = grafwire_with({"fmt", file});
    CHECK(ran.status == 0);
    CHECK(ran.out == english);
    CHECK(ran.err.empty());
    CHECK(grafwire_with({"fmt", file, "--lang", "fr"}).out == french);
    CHECK(grafwire_with({"fmt", "-"}, french).out == english);
    CHECK(text_of(file) == crowded);
}

TEST_CASE("-i replaces the files that are laid out otherwise, and no others") {
    const ScratchFolder folder;
    const std::string first = folder.file("first.grafcet", crowded);
    const std::string second = folder.file("second.grafcet", english);
    const std::string link = folder.path("link.grafcet");
    std::filesystem::create_symlink(first, link);
    std::filesystem::permissions(first, std::filesystem::perms(0640));
    const auto hour_ago = std::filesystem::last_write_time(second) - std::chrono::hours(1);
    std::filesystem::last_write_time(second, hour_ago);
    const Ran ran = grafwire_with({"fmt", "-i", link, second});
    CHECK(ran.status == 0);
    CHECK(ran.out.empty());
    CHECK(ran.err.empty());
    CHECK(text_of(first) == english);
    CHECK(std::filesystem::is_symlink(link));
    CHECK(std::filesystem::status(first).permissions() == std::filesystem::perms(0640));
    CHECK(text_of(second) == english);
    CHECK(std::filesystem::last_write_time(second) == hour_ago);
    CHECK(folder.names() == Names{"first.grafcet", "link.grafcet", "second.grafcet"});
    CHECK(grafwire_with({"fmt", "-i", "--lang", "fr", second}).status == 0);
    CHECK(text_of(second) == french);
}

TEST_CASE("--check lists the files that are laid out otherwise and writes nothing") {
    const ScratchFolder folder;
    const std::string first = folder.file("first.grafcet", crowded);
    const std::string second = folder.file("second.grafcet", english);
    const Ran ran = grafwire_with({"fmt", "--check", second, first});
    CHECK(ran.status == 1);
    CHECK(ran.out == first + "\n");
    CHECK(ran.err.empty());
    CHECK(text_of(first) == crowded);
    const Ran good = grafwire_with({"fmt", "--check", second});
    CHECK(good.status == 0);
    CHECK(good.out.empty());
    CHECK(grafwire_with({"fmt", "--check", second, "--lang", "fr"}).status == 1);
    CHECK(grafwire_with({"fmt", "--check", "-"}, english).status == 0);
    CHECK(grafwire_with({"fmt", "--check", "-"}, crowded).out == "<stdin>\n");
}

TEST_CASE("a file that is wrong does not stop the others, and stays as it is") {
    const ScratchFolder folder;
    const std::string bad = folder.file("bad.grafcet", wrong);
    const std::string file = folder.file("file.grafcet", crowded);
    const std::string none = folder.path("none.grafcet");
    const Ran checked = grafwire_with({"fmt", "--check", bad, none, file});
    CHECK(checked.status == 2);
    CHECK(checked.out == file + "\n");
    CHECK(contains(checked.err, bad + ":2:7: error: "));
    CHECK(contains(checked.err, none + ": error: "));
    const Ran replaced = grafwire_with({"fmt", "-i", bad, none, file});
    CHECK(replaced.status == 2);
    CHECK(text_of(bad) == wrong);
    CHECK(text_of(file) == english);
    const Ran shown = grafwire_with({"fmt", bad});
    CHECK(shown.status == 2);
    CHECK(shown.out.empty());
    CHECK(shown.err == grafwire_with({"info", bad}).err);
}

TEST_CASE("a file that cannot be replaced stays as it is") {
    const ScratchFolder folder;
    const std::string file = folder.file("file.grafcet", crowded);
    std::filesystem::permissions(file, std::filesystem::perms(0444));
    const std::string other = folder.file("other.grafcet", crowded);
    const Ran ran = grafwire_with({"fmt", "-i", file, other});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "cannot write " + file));
    CHECK(text_of(file) == crowded);
    CHECK(text_of(other) == english);
    CHECK(folder.names() == Names{"file.grafcet", "other.grafcet"});
}

TEST_CASE("requests that mean nothing") {
    const ScratchFolder folder;
    const std::string file = folder.file("file.grafcet", crowded);
    const auto refused = [](const Names& request, const std::string& message) {
        const Ran ran = grafwire_with(request);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK_MESSAGE(contains(ran.err, message), ran.err);
    };
    refused({"fmt"}, "FILE is required");
    refused({"fmt", "-i", "--check", file}, "-i and --check exclude each other");
    refused({"fmt", "-i", file, "-"}, "-i replaces files");
    refused({"fmt", file, file}, "only one goes to standard output");
    refused({"fmt", file, file, "--lang", "fr"}, "un seul peut aller sur la sortie standard");
    CHECK(text_of(file) == crowded);
}

TEST_CASE("the examples are in the canonical layout") {
    for (const auto& entry : std::filesystem::directory_iterator(GRAFWIRE_ROOT "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        CHECK(grafwire_with({"fmt", "--check", entry.path().string()}).status == 0);
    }
}

}  // namespace grafwire::testing
