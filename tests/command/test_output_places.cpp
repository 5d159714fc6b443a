// Where results go: files are told apart by what they are and not by their spelling, nothing is
// overwritten by accident, and what replaces a file takes its place as if it had always been there.

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;
using Request = std::vector<std::string>;

std::string trace() {
    return grafwire_with({"run", rule_5_chart, rule_5_stimuli}).out;
}

struct stat status_of(const std::string& path) {
    struct stat status = {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    return status;
}

mode_t rights_of(const std::string& path) {
    return status_of(path).st_mode & 07777;
}

/// Runs grafwire as somebody who is not root and may not write everywhere.
Ran run_as_user(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), GRAFWIRE_PROGRAM);
    if (geteuid() == 0) {
        const Request user{"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
        arguments.insert(arguments.begin(), user.begin(), user.end());
    }
    return run_program(arguments);
}

Ran shell(const std::string& script) {
    return run_program({"sh", "-c", script});
}

const std::string program = "'" + std::string(GRAFWIRE_PROGRAM) + "'";

}  // namespace

TEST_CASE("an input is never overwritten, however it is spelt") {
    const ScratchFolder folder;
    const std::string a = folder.file("a.grafcet", text_of(rule_5_chart));
    const std::string s = folder.file("a.stim", text_of(rule_5_stimuli));
    const std::string io = folder.file("a.io", text_of(example("s7-200/manipulator.io")));
    const std::string awl = folder.file("a.awl", text_of(example("s7-200/manipulator.awl")));
    const std::string big = example("manipulator.grafcet");
    const std::string big_stim = folder.file("b.stim", text_of(example("manipulator.stim")));
    const std::string blif = folder.file(
        "a.blif", grafwire_with({"netlist", rule_5_chart, "--style", "nand", "--to", "blif"}).out);
    fs::create_symlink(a, folder.path("link"));
    fs::create_hard_link(s, folder.path("hard"));
    const std::string crooked =
        folder.path("./../") + fs::path(a).parent_path().filename().string() + "/a.grafcet";
    const Names before = folder.names();
    for (const Request& request : std::vector<Request>{
             {"equations", a, "-o", a},
             {"equations", a, "-o", crooked},
             {"equations", a, "-o", folder.path("link")},
             {"equations", folder.path("link"), "-o", a},
             {"netlist", a, "--style", "nand", "--to", "blif", "-o", crooked},
             {"netlist", a, "--style", "nand", "--to", "spice", "--stim", s, "-o", s},
             {"plc", a, "--to", "c", "-o", a},
             {"plc", big, "--to", "s7-200", "--io", io, "-o", io},
             {"plc", big, "--to", "s7-200", "--io", io, "--addresses", io, "-o", folder.path("x")},
             {"run", a, s, "-o", s},
             {"run", a, s, "-o", folder.path("hard")},
             {"run", a, s, "-o", folder.path("x"), "--vcd", a},
             {"simulate", a, s, "--against", blif, "-o", blif},
             {"simulate", a, s, "--style", "nand", "-o", folder.path("x"), "--vcd", s},
             {"check", a, "--style", "nand", "-o", a},
             {"check", a, "--against", blif, "-o", blif},
             {"s7", "run", awl, "--stim", big_stim, "--scan", "10ms", "--io", io, "-o", awl},
             {"s7", "run", awl, "--stim", big_stim, "--scan", "10ms", "--io", io, "-o", big_stim},
             {"s7", "run", awl, "--stim", big_stim, "--scan", "10ms", "--io", io, "-o",
              folder.path("x"), "--vcd", io}}) {
        CAPTURE(request);
        const Ran ran = grafwire_with(request);
        CHECK(ran.status == 2);
        CHECK(contains(ran.err, "it is the input "));
        CHECK(folder.names() == before);
    }
    CHECK(text_of(a) == text_of(rule_5_chart));
    CHECK(text_of(s) == text_of(rule_5_stimuli));
    // Through standard input and output as well.
    CHECK(shell(program + " equations - -o " + a + " <" + a).status == 2);
    CHECK(shell(program + " equations " + a + " >>" + a).status == 2);
    CHECK(shell(program + " info " + a + " >>" + a).status == 2);
    CHECK(text_of(a) == text_of(rule_5_chart));
}

TEST_CASE("the folder of a witness does not swallow an input") {
    const ScratchFolder folder;
    fs::create_directory(folder.path("w"));
    const std::string a = folder.file("w/witness.txt", text_of(rule_5_chart));
    for (const std::string style : {"nor", "nand"}) {  // different, equivalent
        const Ran ran =
            grafwire_with({"check", a, "--style", style, "--witness", folder.path("w/../w")});
        CHECK(ran.status == 2);
        CHECK(contains(ran.err, "it is the input "));
        CHECK(text_of(a) == text_of(rule_5_chart));
    }
}

TEST_CASE("two results do not meet in one file that is not there yet") {
    const ScratchFolder folder;
    const std::string x = folder.path("x");
    fs::create_symlink("x", folder.path("dangling"));
    for (const std::string& other :
         {folder.path("./x"), folder.path("dangling"),
          folder.path("../" + fs::path(folder.path("")).parent_path().filename().string() +
                      "/x")}) {
        INFO("other spelling: " << other);
        for (const Request& request :
             std::vector<Request>{{"run", rule_5_chart, rule_5_stimuli, "-o", x, "--vcd", other},
                                  {"simulate", rule_5_chart, rule_5_stimuli, "--style", "nand",
                                   "-o", other, "--vcd", x},
                                  {"plc", example("manipulator.grafcet"), "--to", "s7-200", "-o", x,
                                   "--addresses", other}}) {
            const Ran ran = grafwire_with(request);
            CHECK(ran.status == 2);
            CHECK(contains(ran.err, "it is to hold two results"));
            CHECK(folder.names() == Names{"dangling"});
        }
    }
    // A relative path has no folder in its spelling.
    const Ran ran = shell("cd " + folder.path("") + " && " + program + " run " + rule_5_chart +
                          " " + rule_5_stimuli + " -o x --vcd ./x");
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "it is to hold two results"));
    CHECK(folder.names() == Names{"dangling"});
    // Nor in a file that is there under two names, nor both on standard output.
    const std::string file = folder.file("file", "kept");
    fs::create_symlink("file", folder.path("link"));
    CHECK(grafwire_with(
              {"run", rule_5_chart, rule_5_stimuli, "-o", file, "--vcd", folder.path("link")})
              .status == 2);
    CHECK(text_of(file) == "kept");
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "--vcd", "-"}).status == 2);
    CHECK(grafwire_with(
              {"run", rule_5_chart, rule_5_stimuli, "-o", "/dev/null", "--vcd", "/dev/null"})
              .status == 0);
}

TEST_CASE("nobody can foresee the name of the temporary, nor is it one that may be too long") {
    const ScratchFolder folder;
    const std::string victim = folder.file("victim", "untouched");
    // The shell has the number of the process that it becomes.
    const Ran ran = shell("cd " + folder.path("") + " && ln -s victim out.$$.part && exec " +
                          program + " run " + rule_5_chart + " " + rule_5_stimuli + " -o out");
    CHECK(ran.status == 0);
    CHECK(text_of(victim) == "untouched");
    CHECK(!fs::is_symlink(folder.path("out")));
    CHECK(text_of(folder.path("out")) == trace());
    const std::string longest(255, 'n');
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", folder.path(longest)}).status ==
          0);
    CHECK(text_of(folder.path(longest)) == trace());
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", folder.path(longest + "n")})
              .status == 2);
}

TEST_CASE("a signal leaves neither a temporary nor half of the results") {
    for (const std::string signal : {"INT", "TERM", "HUP"}) {
        INFO("signal: " << signal);
        const ScratchFolder folder;
        const std::string csv = folder.file("x.csv", "old");
        // The pipe has no reader: the program waits for one with everything else written.
        const Ran ran =
            shell("cd " + folder.path("") + " && mkfifo pipe && { env --default-signal=INT " +
                  program + " run " + rule_5_chart + " " + rule_5_stimuli +
                  " -o x.csv --vcd pipe & } && i=0; "
                  "until [ $i -gt 300 ] || ls -A | grep -q '^[.]grafwire'; do i=$((i+1)); sleep "
                  "0.01; done;"
                  " kill -" +
                  signal + " $!; wait $!");
        CHECK(ran.status == 128 + (signal == "INT" ? 2 : signal == "TERM" ? 15 : 1));
        CHECK(folder.names() == Names{"pipe", "x.csv"});
        CHECK(text_of(csv) == "old");
    }
}

TEST_CASE("a file beyond the limit of the shell is an error, and leaves nothing") {
    const ScratchFolder folder;
    const Ran ran =
        shell("ulimit -f 1 && " + program + " netlist " + example("manipulator.grafcet") +
              " --style nand --to verilog -o " + folder.path("out"));
    CHECK(ran.status == 2);
    CHECK(folder.names() == Names{});
}

TEST_CASE("what replaces a file has its rights and its owner") {
    const ScratchFolder folder;
    const std::string file = folder.file("file", "old");
    for (const mode_t rights : {0600U, 0640U, 0666U, 0755U}) {
        REQUIRE(chmod(file.c_str(), rights) == 0);
        const bool is_root = geteuid() == 0;
        if (is_root) REQUIRE(chown(file.c_str(), 65534, 65534) == 0);
        CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", file}).status == 0);
        CHECK(text_of(file) == trace());
        CHECK(rights_of(file) == rights);
        if (is_root) CHECK(status_of(file).st_uid == 65534);
        if (is_root) CHECK(status_of(file).st_gid == 65534);
    }
    // A new one has those of any new file.
    const Ran ran = shell("umask 027 && " + program + " run " + rule_5_chart + " " +
                          rule_5_stimuli + " -o " + folder.path("new"));
    CHECK(ran.status == 0);
    CHECK(rights_of(folder.path("new")) == 0640);
}

TEST_CASE("a file that is not to be replaced is refused, with the reason") {
    const ScratchFolder folder;
    const std::string file = folder.file("file", "kept");
    const auto refusal = [&](const Ran& ran) {
        CHECK(ran.status == 2);
        CHECK(text_of(file) == "kept");
        return ran.err;
    };
    REQUIRE(chmod(file.c_str(), 0444) == 0);
    CHECK(contains(refusal(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", file})),
                   "read-only"));
    REQUIRE(chmod(file.c_str(), 0666) == 0);
    fs::create_hard_link(file, folder.path("other"));
    CHECK(contains(refusal(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", file})),
                   "hard links"));
    CHECK(folder.names() == Names{"file", "other"});
    fs::remove(folder.path("other"));
    // The file may be written, its folder not.
    const std::string place = fs::path(file).parent_path().string();
    REQUIRE(chmod(place.c_str(), 0555) == 0);
    CHECK(contains(refusal(run_as_user({"run", rule_5_chart, rule_5_stimuli, "-o", file})),
                   "no file can be made in the folder " + fs::canonical(place).string()));
    REQUIRE(chmod(place.c_str(), 0777) == 0);
    // A new file would belong to another user.
    if (geteuid() == 0) {
        CHECK(contains(refusal(run_as_user({"run", rule_5_chart, rule_5_stimuli, "-o", file})),
                       "another user"));
    }
    CHECK(folder.names() == Names{"file"});
}

TEST_CASE("links are followed, those that lead to nothing as well") {
    const ScratchFolder folder;
    fs::create_directory(folder.path("inner"));
    fs::create_symlink("inner/file", folder.path("a"));
    fs::create_symlink("a", folder.path("b"));
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", folder.path("b")}).status == 0);
    CHECK(fs::is_symlink(folder.path("a")));
    CHECK(fs::is_symlink(folder.path("b")));
    CHECK(text_of(folder.path("inner/file")) == trace());
    fs::create_symlink("loop", folder.path("loop"));
    fs::create_symlink("none/file", folder.path("nowhere"));
    for (const std::string name : {"loop", "nowhere"}) {
        const Ran ran =
            grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", folder.path(name)});
        CHECK(ran.status == 2);
        CHECK(contains(ran.err, "cannot write " + folder.path(name)));
        CHECK(fs::is_symlink(folder.path(name)));
    }
    CHECK(folder.names() == Names{"a", "b", "inner", "loop", "nowhere"});
}

TEST_CASE("what goes to standard output is part of the whole") {
    const ScratchFolder folder;
    const std::string check = program + " check " + rule_5_chart + " --style nor --witness ";
    for (const std::string end : {" >/dev/full", " >&-"}) {
        INFO("standard output: " << end);
        CHECK(shell(check + folder.path("w/deep") + end).status == 2);
        CHECK(folder.names() == Names{});
        CHECK(shell(program + " run " + rule_5_chart + " " + rule_5_stimuli + " --vcd " +
                    folder.path("vcd") + end)
                  .status == 2);
        CHECK(folder.names() == Names{});
        for (const std::string option : {"--help", "--version", "check --help"}) {
            const Ran ran = shell(program + " " + option + end);
            CHECK(ran.status == 2);
            CHECK(contains(ran.err, "cannot write standard output"));
        }
    }
}

TEST_CASE("what cannot be said on standard error changes nothing else") {
    const ScratchFolder folder;
    // Two steps that follow each other: a warning.
    const std::string chart =
        folder.file("a.grafcet", "input a\ngraph G { initial 0 step 1 0 -> 1 : a 1 -> 0 : /a }\n");
    const std::string equations = grafwire_with({"equations", chart}).out;
    CHECK(!grafwire_with({"equations", chart}).err.empty());
    for (const std::string end : {" 2>/dev/full", " 2>&-", " <&- 2>&-"}) {
        INFO("standard error: " << end);
        const Ran ran = shell(program + " equations " + chart + end);
        CHECK(ran.status == 0);
        CHECK(ran.out == equations);
        // Nor does a message get into a file that is open instead.
        CHECK(shell(program + " equations " + chart + " -o " + folder.path("out") + end).status ==
              0);
        CHECK(text_of(folder.path("out")) == equations);
        CHECK(shell(program + " info " + folder.path("none") + end).status == 2);
        CHECK(shell(program + " check " + rule_5_chart + " --style nor" + end).status == 1);
    }
}

TEST_CASE("the folder of a witness holds that of the last verdict or none") {
    const ScratchFolder folder;
    const std::string w = folder.path("w");
    CHECK(grafwire_with({"check", rule_5_chart, "--style", "nor", "--witness", w}).status == 1);
    CHECK(fs::exists(w + "/witness.stim"));
    folder.file("w/notes.txt", "my own");
    // Undecided, and equivalent: what is not of a witness stays.
    for (const bool decided : {false, true}) {
        folder.file("w/got.csv", "old");
        Request request{"check", rule_5_chart, "--style", "nand", "--witness", w};
        if (!decided) request.insert(request.end(), {"--max-cases", "1"});
        CHECK(grafwire_with(request).status == (decided ? 0 : 3));
        CHECK(std::distance(fs::directory_iterator(w), {}) == 1);
        CHECK(text_of(w + "/notes.txt") == "my own");
    }
    // Nothing goes where the answer cannot be written.
    folder.file("w/got.csv", "old");
    CHECK(
        grafwire_with({"check", rule_5_chart, "--style", "nand", "--witness", w, "-o", "/dev/full"})
            .status == 2);
    CHECK(text_of(w + "/got.csv") == "old");
    CHECK(grafwire_with({"check", rule_5_chart, "--style", "nand", "--witness", folder.path("new")})
              .status == 0);
    CHECK(folder.names() == Names{"w"});
}

}  // namespace grafwire::testing
