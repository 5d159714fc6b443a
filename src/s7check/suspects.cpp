#include "s7check/suspects.h"

#include <algorithm>

#include "s7check/method_tables.h"

namespace grafwire {

namespace {

using s7::Operand;

bool sets_in(const s7::Network& network, Suspects::Bytes bytes) {
    return std::any_of(network.instructions.begin(), network.instructions.end(),
                       [&](const s7::Instruction& instruction) {
                           return instruction.operation == s7::Operation::set &&
                                  may_write_bytes(instruction, bytes.first, bytes.count);
                       });
}

constexpr Suspects::Bytes anywhere{0, 4096};

}  // namespace

Finding Suspects::written(Finding::Kind kind, std::string name, const Operand& place,
                          bool expected) const {
    Finding finding;
    finding.kind = kind;
    finding.name = std::move(name);
    finding.place = place;
    finding.expected = expected;
    finding.at = now_;
    const auto writer = machine_->writer(place);
    if (writer) {
        finding.networks.push_back(number(writer->network));
        follow_reads(finding, writer->network, 2);
        add_networks(finding, jumps_over(writer->network), false);
    }
    // What may write the bit and has not done so in this scan comes next.
    if (!writer || !writer->in_last_scan) {
        finding.should_have_written = !writer;
        add_networks(finding, writers_of(place), false);
    }
    return finding;
}

/// Puts networks before those found so far, in their order, or behind them.
void Suspects::add_networks(Finding& finding, const std::vector<std::uint32_t>& networks,
                            bool in_front) const {
    std::vector<std::uint32_t> added;
    for (const std::uint32_t n : networks) added.push_back(number(n));
    std::vector<std::uint32_t>& all = finding.networks;
    if (in_front) {
        std::erase_if(all, [&](std::uint32_t n) {
            return std::find(added.begin(), added.end(), n) != added.end();
        });
        all.insert(all.begin(), added.begin(), added.end());
        return;
    }
    for (const std::uint32_t n : added) {
        if (std::find(all.begin(), all.end(), n) == all.end()) all.push_back(n);
    }
}

void Suspects::blame_instead(Finding& finding, const std::vector<std::uint32_t>& networks) const {
    if (networks.empty()) return;
    add_networks(finding, networks, true);
    finding.should_have_written = true;
}

std::vector<std::uint32_t> Suspects::setters_for(const Operand& bit) const {
    auto networks =
        networks_where(listing_, [&](const auto& instruction) { return loads(instruction, bit); });
    std::erase_if(networks,
                  [&](std::uint32_t n) { return !sets_in(listing_.networks[n], anywhere); });
    return networks;
}

std::vector<std::uint32_t> Suspects::setters_for_step(std::size_t step, Bytes bytes) const {
    const Operand& now = *binding_.steps[step];
    const Operand before = MethodTables::in(MethodTables::previous, now);
    const auto networks = networks_where(listing_, [&](const auto& instruction) {
        return loads(instruction, now) || loads(instruction, before);
    });
    for (const Bytes wanted : {bytes, anywhere}) {
        std::vector<std::uint32_t> setters;
        for (const std::uint32_t n : networks) {
            if (sets_in(listing_.networks[n], wanted)) setters.push_back(n);
        }
        if (!setters.empty()) return setters;
    }
    return {};
}

std::optional<bool> Suspects::read_as(const Operand& bit, std::uint32_t network) const {
    for (const s7::Machine::Read& read : reads_) {
        if (read.operand == bit && (network == no_network || read.network == network)) {
            return read.value;
        }
    }
    return std::nullopt;
}

std::vector<std::uint32_t> Suspects::runners_of(const Operand& timer) const {
    return networks_where(listing_, [&](const auto& instruction) {
        return instruction.operation == s7::Operation::on_delay && instruction.operands[0] == timer;
    });
}

std::vector<std::uint32_t> Suspects::silent_writers_of_ts() const {
    auto networks = networks_where(listing_, [&](const auto& instruction) {
        return instruction.operation == s7::Operation::move &&
               may_write_bytes(instruction, MethodTables::first_byte_of_ts, MethodTables::bytes);
    });
    std::erase_if(networks, [&](std::uint32_t n) { return machine_->wrote_in_last_scan(n); });
    return networks;
}

std::vector<std::uint32_t> Suspects::writers_of(const Operand& place) const {
    return networks_where(listing_,
                          [&](const auto& instruction) { return may_write(instruction, place); });
}

/// The networks with a jump from before a network to behind it, in the same block.
std::vector<std::uint32_t> Suspects::jumps_over(std::uint32_t network) const {
    std::vector<std::uint32_t> networks;
    for (const s7::Outline::Block& block : outline_.blocks) {
        for (std::size_t line = block.first; line < block.end; ++line) {
            const s7::Instruction& instruction = outline_.at(line);
            if (instruction.operation != s7::Operation::jump) continue;
            const std::size_t target = block.labels.at(instruction.operands[0].address);
            if (outline_.lines[line].network < network &&
                outline_.lines[target].network > network) {
                networks.push_back(outline_.lines[line].network);
            }
        }
    }
    return networks;
}

bool Suspects::is_told_by_the_tables(const Operand& place) const {
    if (place.area == s7::Area::input || place.area == s7::Area::special) return true;
    for (const auto* list : {&binding_.steps, &binding_.transitions, &binding_.graphs}) {
        if (std::find(list->begin(), list->end(), place) != list->end()) return true;
    }
    return false;
}

/// What a network read in this scan besides inputs and tables, and who had written that.
void Suspects::follow_reads(Finding& finding, std::uint32_t network, int depth) const {
    if (depth == 0) return;
    for (const s7::Machine::Read& read : reads_) {
        if (read.network != network || is_told_by_the_tables(read.operand)) continue;
        const bool is_known = std::any_of(
            finding.reads.begin(), finding.reads.end(), [&](const Finding::Read& other) {
                return other.place == read.operand && other.network == number(network);
            });
        if (is_known) continue;
        Finding::Read told{number(network), read.operand, read.value, std::nullopt};
        if (read.writer) told.writer = number(read.writer->network);
        finding.reads.push_back(told);
        if (read.writer) {
            add_networks(finding, {read.writer->network}, false);
            follow_reads(finding, read.writer->network, depth - 1);
        }
        add_networks(finding, writers_of(read.operand), false);
    }
}

}  // namespace grafwire
