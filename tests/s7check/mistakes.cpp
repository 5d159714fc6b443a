#include "s7check/mistakes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "s7/addresses/operand.h"
#include "s7check/candidate_networks.h"
#include "support/listings.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        const std::size_t first = part.find_first_not_of(' ');
        const std::size_t last = part.find_last_not_of(' ');
        parts.push_back(first == std::string::npos ? "" : part.substr(first, last - first + 1));
    }
    return parts;
}

/// The texts between backticks of a cell.
std::vector<std::string> quoted(const std::string& cell) {
    const std::vector<std::string> parts = split(cell, '`');
    std::vector<std::string> texts;
    for (std::size_t i = 1; i < parts.size(); i += 2) texts.push_back(parts[i]);
    return texts;
}

std::vector<s7::Instruction> instructions_of(const std::string& text) {
    std::string lines = "NETWORK1\n";
    for (const std::string& line : split(text, ';')) lines += line + '\n';
    const SourceFile source{"README.md", lines};
    Diagnostics diagnostics;
    const auto listing = s7::parse_listing(source, {s7::Cpu::cpu_214, nullptr, true}, diagnostics);
    REQUIRE_MESSAGE(listing.has_value(), format_diagnostics(diagnostics, source));
    return listing->networks[0].instructions;
}

bool same(const s7::Instruction& a, const s7::Instruction& b) {
    return a.operation == b.operation && a.width == b.width && a.compare == b.compare &&
           a.operands == b.operands;
}

void replace_operand(s7::Network& network, const s7::Operand& from, const s7::Operand& to) {
    bool found = false;
    for (s7::Instruction& instruction : network.instructions) {
        for (s7::Operand& operand : instruction.operands) {
            if (operand != from) continue;
            operand = to;
            found = true;
        }
    }
    CHECK_MESSAGE(found, "network " << network.number);
}

void replace_instructions(s7::Network& network, const std::string& from, const std::string& to) {
    const auto printed = instructions_of(from);
    const auto found = std::search(network.instructions.begin(), network.instructions.end(),
                                   printed.begin(), printed.end(), same);
    REQUIRE_MESSAGE(found != network.instructions.end(),
                    "network " << network.number << ": " << from);
    const auto at =
        network.instructions.erase(found, found + static_cast<std::ptrdiff_t>(printed.size()));
    const auto wanted = instructions_of(to);
    network.instructions.insert(at, wanted.begin(), wanted.end());
}

}  // namespace

bool Mistake::concerns(std::uint32_t network) const {
    return std::any_of(corrections.begin(), corrections.end(),
                       [&](const Correction& row) { return row.network == network; });
}

bool Mistake::writes(const s7::Operand& bit) const {
    for (const Correction& row : corrections) {
        for (const std::string& text : row.must_be) {
            if (s7::parse_operand(text)) continue;
            for (const s7::Instruction& instruction : instructions_of(text)) {
                if (may_write(instruction, bit)) return true;
            }
        }
    }
    return false;
}

std::vector<Mistake> mistakes_of(const std::string& heading) {
    std::istringstream readme(example_text("s7-200/README.md"));
    std::vector<Mistake> mistakes;
    bool is_here = false;
    for (std::string line; std::getline(readme, line);) {
        if (line.starts_with("#")) is_here = line == "### " + heading;
        if (!is_here || !line.starts_with("|") || line.starts_with("|---")) continue;
        const std::vector<std::string> cells = split(line, '|');
        REQUIRE(cells.size() == 7);
        if (cells[1] == "no.") continue;
        if (!cells[1].empty()) mistakes.push_back({cells[1], cells[6], {}});
        REQUIRE(mistakes.back().found_by == cells[6]);
        Correction row;
        row.network = static_cast<std::uint32_t>(std::stoul(cells[2]));
        row.printed = quoted(cells[3]);
        row.must_be = quoted(cells[4]);
        row.of_offsets = row.printed.empty();
        REQUIRE(row.printed.size() == row.must_be.size());
        mistakes.back().corrections.push_back(row);
    }
    REQUIRE_FALSE(mistakes.empty());
    return mistakes;
}

void correct(s7::Listing& listing, const Mistake& mistake) {
    for (const Correction& row : mistake.corrections) {
        const auto network = std::find_if(
            listing.networks.begin(), listing.networks.end(),
            [&](const s7::Network& candidate) { return candidate.number == row.network; });
        REQUIRE(network != listing.networks.end());
        for (std::size_t i = 0; i < row.printed.size(); ++i) {
            const auto from = s7::parse_operand(row.printed[i]);
            const auto to = s7::parse_operand(row.must_be[i]);
            REQUIRE(from.has_value() == to.has_value());
            if (from) {
                replace_operand(*network, *from, *to);
            } else {
                replace_instructions(*network, row.printed[i], row.must_be[i]);
            }
        }
    }
}

}  // namespace grafwire::testing
