#include "plc/pl7_listing.h"

#include <regex>
#include <sstream>
#include <unordered_map>

namespace grafwire::testing {

namespace {

class Pl7Reader {
  public:
    Pl7Listing read(const std::string& text);

  private:
    void read_transition(const std::string& line);
    Pl7Rung read_rung(const std::string& line) const;
    [[noreturn]] void fail(const std::string& message) const { throw PlcError(line_, message); }

    Pl7Listing listing_;
    std::size_t line_ = 0;
};

Pl7Listing Pl7Reader::read(const std::string& text) {
    std::istringstream lines(text);
    std::string part = "HEAD";
    bool has_label = false;
    for (std::string line; std::getline(lines, line);) {
        ++line_;
        if (line == "ASSIGNMENT" || line == "PRELIMINARY PROCESSING" ||
            line == "SEQUENTIAL PROCESSING" || line == "POSTERIOR PROCESSING") {
            part = line;
            has_label = false;
        } else if (line.empty() || part == "HEAD") {
            continue;
        } else if (part == "ASSIGNMENT") {
            if (line.size() < 12) fail("an assignment");
            const std::string object = line.substr(3, line.find(' ', 3) - 3);
            listing_.symbols.emplace(std::make_pair(line.substr(12), object.front()), object);
        } else if (line.rfind("** LABEL ", 0) == 0 && part != "SEQUENTIAL PROCESSING") {
            has_label = true;
        } else if (part != "SEQUENTIAL PROCESSING") {
            if (!has_label) fail("a rung without a label");
            (part == "PRELIMINARY PROCESSING" ? listing_.preliminary : listing_.posterior)
                .push_back(read_rung(line));
        } else if (line.rfind("** ", 0) == 0) {
            read_transition(line);
        } else if (listing_.transitions.empty()) {
            static const std::regex step_form("   ([ #]) (X\\d\\d?) .*");
            std::smatch parts;
            if (!std::regex_match(line, parts, step_form)) fail("a step");
            if (!listing_.steps.insert(parts[2]).second) fail("a step twice");
            if (parts[1] == "#") listing_.initial.insert(parts[2]);
        } else {
            if (!listing_.transitions.back().rung.coil.empty()) fail("two rungs for a transition");
            listing_.transitions.back().rung = read_rung(line);
            if (listing_.transitions.back().rung.coil != "(#)")
                fail("not the coil of a transition");
        }
    }
    for (const Pl7Transition& transition : listing_.transitions) {
        if (transition.rung.coil.empty()) fail("a transition without a rung");
    }
    return std::move(listing_);
}

void Pl7Reader::read_transition(const std::string& line) {
    static const std::regex form("\\*\\* (X[X\\d ]*) --> (X[X\\d ]*)   .*");
    std::smatch parts;
    if (!std::regex_match(line, parts, form)) fail("a transition");
    Pl7Transition transition;
    const auto names = [&](const std::string& text) {
        std::istringstream words(text);
        std::vector<std::string> result;
        for (std::string word; words >> word;) {
            if (listing_.steps.count(word) == 0) fail("the step " + word);
            result.push_back(word);
        }
        return result;
    };
    transition.before = names(parts[1]);
    transition.after = names(parts[2]);
    listing_.transitions.push_back(transition);
}

Pl7Rung Pl7Reader::read_rung(const std::string& line) const {
    const std::size_t wire = line.find(" --");
    if (line.rfind("   ", 0) != 0 || wire == std::string::npos) fail("a rung");
    return {line.substr(3, wire - 3), line.substr(wire + 3), line_};
}

}  // namespace

Pl7Listing read_pl7(const std::string& text) {
    return Pl7Reader().read(text);
}

bool is_pl7_bit(const std::string& object) {
    static const std::regex form(
        "(I|O)[0-3],(\\d|1\\d|2[0-3])|B\\d{1,3}|X\\d\\d?|T\\d\\d?,D|SY(0|21|22|23)");
    // Asked for every contact in every scan, of few objects.
    static std::unordered_map<std::string, bool> known;
    const auto found = known.find(object);
    if (found != known.end()) return found->second;
    return known.emplace(object, std::regex_match(object, form)).first->second;
}

}  // namespace grafwire::testing
