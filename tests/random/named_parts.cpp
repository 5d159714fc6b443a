#include "random/named_parts.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <sstream>
#include <utility>
#include <vector>

#include "random/random_source.h"

namespace grafwire::testing {

namespace {

std::uint64_t seed_of(const std::string& text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    return hash;
}

bool begins_with(const std::string& line, const std::string& word) {
    return line.compare(0, word.size(), word) == 0;
}

void replace_all(std::string& text, const std::string& old, const std::string& by) {
    for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + by.size())) {
        text.replace(at, old.size(), by);
    }
}

class Rewriter {
  public:
    explicit Rewriter(const std::string& chart) : random_(seed_of(chart)) {
        std::istringstream text(chart);
        for (std::string line; std::getline(text, line);) lines_.push_back(line);
    }

    std::string rewrite(bool held) {
        if (held && random_.one_in(4)) hold_var();
        if (random_.one_in(3)) name_condition();
        if (random_.one_in(3)) name_duration();
        if (random_.flip()) spell_otherwise();
        std::string text;
        for (const std::string& line : lines_) text += line + "\n";
        return text;
    }

  private:
    /// Before the graphs, behind all other declarations.
    void declare(const std::string& line) {
        auto at = lines_.begin();
        while (at != lines_.end() && !begins_with(*at, "graph") && !begins_with(*at, "expansion")) {
            ++at;
        }
        lines_.insert(at, line);
    }

    /// The numbers of lines with a transition whose condition stands behind " : ".
    std::vector<std::size_t> conditions() const {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::size_t arrow = lines_[i].find("->");
            if (arrow != std::string::npos && lines_[i].find(" : ", arrow) != std::string::npos) {
                found.push_back(i);
            }
        }
        return found;
    }

    std::string first_input() const {
        for (const std::string& line : lines_) {
            if (begins_with(line, "input ")) return line.substr(6, line.find(',') - 6);
        }
        return {};
    }

    void hold_var() {
        std::vector<std::size_t> steps;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (begins_with(lines_[i], "  step ") || begins_with(lines_[i], "  initial ")) {
                steps.push_back(i);
            }
        }
        const std::vector<std::size_t> readers = conditions();
        if (steps.empty() || readers.empty()) return;
        std::string& step = lines_[random_.pick(steps)];
        step += step.find(" : ") == std::string::npos ? " : held_bit" : ", held_bit";
        const std::string input = first_input();
        if (random_.flip() && !input.empty()) step += " if " + input;
        std::string& reader = lines_[random_.pick(readers)];
        const std::size_t at = reader.find(" : ", reader.find("->")) + 3;
        reader.insert(at, random_.flip() ? "held_bit + " : "/held_bit . ");
        declare("var held_bit");
    }

    void name_condition() {
        const std::vector<std::size_t> readers = conditions();
        if (readers.empty()) return;
        std::string& reader = lines_[random_.pick(readers)];
        const std::size_t at = reader.find(" : ", reader.find("->")) + 3;
        const std::size_t end = std::min(reader.find(" do ", at), reader.size());
        const std::string condition = reader.substr(at, end - at);
        reader.replace(at, end - at, "named_condition");
        declare("define named_condition = " + condition);
    }

    /// `5ms/` becomes a name, where it stands by itself.
    void name_duration() {
        for (const std::size_t i : conditions()) {
            std::string& line = lines_[i];
            const std::size_t unit = line.find("ms/");
            if (unit == std::string::npos) continue;
            std::size_t at = unit;
            while (at > 0 && (std::isdigit(static_cast<unsigned char>(line[at - 1])) != 0 ||
                              line[at - 1] == '.')) {
                --at;
            }
            const bool is_alone = line[at - 1] == ' ' || line[at - 1] == '(' || line[at - 1] == '!';
            if (at == unit || !is_alone || line[at] == '.') continue;
            const std::string duration = line.substr(at, unit + 2 - at);
            line.replace(at, unit + 2 - at, "named_time");
            declare("time named_time = " + duration);
            return;
        }
    }

    void spell_otherwise() {
        static const std::pair<const char*, const char*> at_the_head[] = {
            {"input ", "entrée "},         {"output ", "SORTIE "},   {"var ", "variable "},
            {"counter ", "compteur "},     {"graph ", "graphe "},    {"  step ", "  étape "},
            {"  initial ", "  initiale "}, {"  entry ", "  début "}, {"  exit ", "  fin "},
            {"define ", "définir "},       {"time ", "duree "}};
        static const std::pair<const char*, const char*> anywhere[] = {
            {" and ", " et "},
            {" or ", " OU "},
            {"not ", "non "},
            {" & ", " ∧ "},
            {" | ", " ∨ "},
            {"->", "→"},
            {" if ", " si "},
            {" do ", " faire "},
            {" on ", " sur "},
            {" on deactivation", " sur désactivation"},
            {" encloses ", " englobe "},
            {"<=", "≤"}};
        for (std::string& line : lines_) {
            if (line.find('"') != std::string::npos || random_.one_in(4)) continue;
            for (const auto& [old, by] : at_the_head) {
                if (begins_with(line, old)) line.replace(0, std::string(old).size(), by);
            }
            for (const auto& [old, by] : anywhere) replace_all(line, old, by);
        }
    }

    RandomSource random_;
    std::vector<std::string> lines_;
};

}  // namespace

std::string with_named_parts(const std::string& chart, bool held) {
    return Rewriter(chart).rewrite(held);
}

}  // namespace grafwire::testing
