// Everything that can fail fails, in turn: memory, then opening, reading, writing and renaming
// files and making folders, at the first time, the second, …, once and from there on, in every
// command. Whatever fails, the program ends with a status that is documented: 2, with a message,
// and then no file has changed; or, where it could do without, the one it ends with otherwise, and
// then all is written. Nothing else is left behind.
//
// Here a sample, each command on one example; tools/fail-everything takes all of it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;
using Folder = std::map<std::string, std::string>;  ///< texts by their paths

/// What a command works on, under names that are the same for all examples.
const Words examples{"rule-5", "single-sequence", "press"};

/// A command in a folder that holds the example as c.grafcet and c.stim, and what was made of it.
/// `old` are files that it replaces.
struct Request {
    Words words;
    Words old;
};

const std::vector<Request> requests{
    {{"info", "c.grafcet"}, {}},
    {{"equations", "c.grafcet", "--to", "markdown", "-o", "out"}, {"out"}},
    {{"run", "c.grafcet", "c.stim", "-o", "out", "--vcd", "c.vcd"}, {"out", "c.vcd"}},
    {{"run", "c.grafcet", "c.stim", "--explain", "--to", "svg", "-o", "out"}, {}},
    {{"run", "c.grafcet", "c.stim", "--vcd", "c.fst"}, {"c.fst"}},
    {{"netlist", "c.grafcet", "--style", "clocked", "--to", "verilog", "-o", "out"}, {"out"}},
    {{"netlist", "c.grafcet", "--style", "clocked", "--to", "spice", "--stim", "c.stim"}, {}},
    {{"simulate", "c.grafcet", "c.stim", "--style", "clocked", "--scan", "10ms", "-o", "out",
      "--vcd", "c.vcd"},
     {"c.vcd"}},
    {{"check", "c.grafcet", "--style", "nor", "--max-cases", "300", "--witness", "w/w", "-o",
      "out"},
     {"out"}},
    {{"check", "c.grafcet", "--against", "c.blif", "--max-cases", "300", "--to", "json"}, {}},
    {{"check", "c.grafcet", "--against", "c.json", "--max-cases", "300", "--to", "json"}, {}},
    {{"check", "c.grafcet", "--against", "c.xml", "--max-cases", "300", "-o", "out"}, {"out"}},
    {{"plc", "c.grafcet", "--to", "ladder-svg", "-o", "out"}, {}},
    {{"plc", "c.grafcet", "--to", "plcopen", "-o", "out"}, {"out"}},
    {{"plc", "c.grafcet", "--to", "s7-200", "-o", "out", "--addresses", "c.io"}, {"out", "c.io"}},
    {{"s7", "run", "c.awl", "--stim", "c.stim", "--scan", "10ms", "--io", "all.io", "-o", "out",
      "--vcd", "c.vcd"},
     {"out"}},
    {{"draw", "c.grafcet", "-o", "out.svg"}, {"out.svg"}},
    {{"report", "c.grafcet", "c.stim", "-o", "out.html"}, {"out.html"}},
    {{"fmt", "c.grafcet", "-i"}, {}},
    {{"--help"}, {}},
};

const Words kinds{"memory", "open", "read", "write", "rename", "folder"};

/// GRAFWIRE_FAILURES=I/N: everything, as the I-th of N programs that share the work.
struct Share {
    std::size_t index = 0;
    std::size_t count = 0;  ///< 0: a sample
};

Share share() {
    Share result;
    if (const char* wish = std::getenv("GRAFWIRE_FAILURES")) {
        char* end = nullptr;
        result.index = std::strtoul(wish, &end, 10);
        REQUIRE(*end == '/');
        result.count = std::strtoul(end + 1, nullptr, 10);
        REQUIRE(result.count != 0);
    }
    return result;
}

/// The texts of all that is below a folder; empty for a folder.
Folder content_of(const std::string& folder) {
    Folder content;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        content[name] = entry.is_directory() ? "" : text_of(entry.path().string());
    }
    return content;
}

/// The chart, its stimuli, and the files that other commands have made of it.
class Inputs {
  public:
    explicit Inputs(const std::string& name) {
        folder_.file("c.grafcet", example_text(name + ".grafcet"));
        folder_.file("c.stim", example_text(name + ".stim"));
        make({"netlist", "--style", "clocked", "--to", "blif"}, "c.blif");
        make({"netlist", "--style", "clocked", "--to", "json"}, "c.json");
        make({"plc", "--to", "plcopen"}, "c.xml");
        make({"plc", "--to", "s7-200", "--addresses", folder_.path("all.io")}, "c.awl");
    }

    /// Makes a folder what it was before: these, and files of an earlier time.
    void copy_to(const std::string& folder, const Words& old) const {
        fs::remove_all(folder);
        fs::create_directory(folder);
        for (const std::string& name : folder_.names()) {
            fs::copy_file(folder_.path(name), folder + "/" + name);
        }
        for (const std::string& name : old) {
            std::ofstream(folder + "/" + name) << "of an earlier time";
        }
    }

  private:
    void make(Words words, const std::string& name) {
        words.insert(words.begin() + 1, folder_.path("c.grafcet"));
        words.insert(words.end(), {"-o", folder_.path(name)});
        REQUIRE(grafwire_with(words).status == 0);
    }

    ScratchFolder folder_;
};

/// One command on one example.
class Trial {
  public:
    Trial(const Inputs& inputs, const Request& request) : inputs_(inputs), request_(request) {
        reset();
        before_ = content_of(place());
        usual_ = run({});
        after_ = content_of(place());
    }

    /// How often the command makes calls of a kind.
    unsigned long calls_of(const std::string& kind) {
        reset();
        const std::string file = folder_.path("calls");
        run({"LD_PRELOAD=" GRAFWIRE_FAILING_CALLS, "GRAFWIRE_FAIL=" + kind + ":0:once",
             "GRAFWIRE_CALLS=" + file});
        return std::stoul(text_of(file));
    }

    /// Lets the n-th call fail. `how`: "once", or "ever" for those after it as well.
    void fail(const std::string& kind, unsigned long n, const std::string& how) {
        reset();
        const std::string wish = kind + ":" + std::to_string(n) + ":" + how;
        const Ran ran = run({"LD_PRELOAD=" GRAFWIRE_FAILING_CALLS, "GRAFWIRE_FAIL=" + wish});
        CAPTURE(wish);
        CAPTURE(request_.words);
        CAPTURE(ran.err);
        const Folder now = content_of(place());
        if (ran.status == 2 && usual_.status != 2) {
            CHECK(contains(ran.err, "error: "));
            // Where taking back fails as well, every file is still the old one or the new one.
            if (kind == "rename" && how == "ever" && n > 1) return check_whole(now);
            CHECK(now == before_);
        } else {
            CHECK(ran.status == usual_.status);
            CHECK(ran.out == usual_.out);
            CHECK(now == after_);
        }
    }

  private:
    std::string place() const { return folder_.path("work"); }
    void reset() const { inputs_.copy_to(place(), request_.old); }

    Ran run(const Words& environment) const {
        Words words{"env", "-C", place()};
        words.insert(words.end(), environment.begin(), environment.end());
        words.push_back("TMPDIR=" + place());  // what is left behind there is seen
        words.push_back(GRAFWIRE_PROGRAM);
        words.insert(words.end(), request_.words.begin(), request_.words.end());
        return run_program(words);
    }

    void check_whole(const Folder& now) const {
        for (const auto& [name, text] : now) {
            if (name.starts_with(".grafwire-")) continue;
            const auto old = before_.find(name);
            const auto fresh = after_.find(name);
            CHECK(((old != before_.end() && old->second == text) ||
                   (fresh != after_.end() && fresh->second == text)));
        }
    }

    const Inputs& inputs_;
    const Request& request_;
    ScratchFolder folder_;
    Folder before_, after_;
    Ran usual_;
};

/// All of them, or a sample: the first and the last ones, and some between. Of a command that takes
/// memory hundreds of thousands of times only so many are ever tried.
std::vector<unsigned long> chosen(unsigned long count, bool all) {
    constexpr unsigned long most = 20'000;
    constexpr unsigned long few = 8;
    const unsigned long step = all ? count / most + 1 : count / few + 1;
    std::vector<unsigned long> numbers;
    for (unsigned long n = 1; n <= count; ++n) {
        if (n % step == 0 || n == 1 || n == count) numbers.push_back(n);
    }
    return numbers;
}

/// Every call of every kind, or a sample of them; returns how many.
std::size_t fail_in_turn(Trial& trial, bool all) {
    std::size_t failures = 0;
    for (const std::string& kind : kinds) {
        for (const unsigned long n : chosen(trial.calls_of(kind), all)) {
            for (const std::string how : {"once", "ever"}) {
                trial.fail(kind, n, how);
                ++failures;
            }
        }
    }
    return failures;
}

}  // namespace

TEST_CASE(
    "whatever fails, files are as they were or as they should be, and nothing else is there") {
    const Share mine = share();
    const bool all = mine.count != 0;
    std::size_t failures = 0;
    for (std::size_t e = 0; e < examples.size(); ++e) {
        INFO("example: " << examples[e]);
        const Inputs inputs(examples[e]);
        for (std::size_t r = 0; r < requests.size(); ++r) {
            const bool is_mine = all ? (e * requests.size() + r) % mine.count == mine.index
                                     : r % examples.size() == e;
            if (!is_mine) continue;
            Trial trial(inputs, requests[r]);
            failures += fail_in_turn(trial, all);
        }
    }
    MESSAGE(failures << " failures");
}

TEST_CASE("memory that is limited from outside runs out with a message in either language") {
    const ScratchFolder folder;
    std::string chart = "input a\ngraph G {\ninitial 0\n";
    for (int i = 1; i < 50'000; ++i) {
        const std::string step = std::to_string(i);
        chart += "step " + step + "\n" + std::to_string(i - 1) + " -> " + step + " : a\n";
    }
    const std::string big = folder.file("big.grafcet", chart + "}\n");
    const std::string out = folder.file("out", "of an earlier time");
    const Words names = folder.names();
    const auto limited = [&](const std::string& request) {
        return run_program(
            {"sh", "-c",
             "ulimit -v 100000; exec '" + std::string(GRAFWIRE_PROGRAM) + "' " + request});
    };
    const std::string netlist = "netlist " + big + " --style nand --to verilog -o " + out;
    const Ran english = limited(netlist);
    CHECK(english.status == 2);
    CHECK(english.err == "grafwire: error: there is not enough memory\n");
    const Ran french = limited("--lang fr " + netlist);
    CHECK(french.status == 2);
    CHECK(french.err == "grafwire: erreur : il n'y a pas assez de mémoire\n");
    CHECK(text_of(out) == "of an earlier time");
    CHECK(folder.names() == names);
    // CI, which may see nothing but the report, is told as well.
    const Ran check = limited("check " + big + " --style nand --to junit");
    CHECK(check.status == 2);
    CHECK(contains(check.err, "with --max-memory it ends before that"));
    CHECK(contains(check.out, "there is not enough memory for this check"));
}

}  // namespace grafwire::testing
