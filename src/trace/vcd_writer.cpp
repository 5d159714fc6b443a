// Waveforms as value change dumps (IEEE 1364-2001, clause 18): signals are declared under short
// identifiers of printable characters, then only changes are written.

#include "trace/vcd_writer.h"

#include <fmt/format.h>

#include <cassert>
#include <iterator>
#include <utility>

namespace grafwire {

namespace {

/// A name as one word of a VCD. A leading `$` would make it a keyword.
std::string one_word(std::string_view name) {
    std::string word(name);
    for (char& c : word) {
        if (static_cast<unsigned char>(c) <= ' ' || c == '\x7f') c = '_';
    }
    if (word.empty()) return "_";
    if (word.front() == '$') word.front() = '_';
    return word;
}

std::string_view timescale(Time tick) {
    if (tick == millisecond) return "1 ms";
    if (tick == microsecond) return "1 us";
    if (tick == nanosecond) return "1 ns";
    assert(tick == 1);
    return "1 ps";
}

}  // namespace

VcdWriter::VcdWriter(std::string_view scope, Time tick)
    : text_(fmt::format("$version grafwire $end\n$timescale {} $end\n$scope module {} $end\n",
                        timescale(tick), one_word(scope))),
      tick_(tick) {}

std::string VcdWriter::identifier(std::uint32_t signal) {
    constexpr std::uint32_t printable = 94;  // '!' to '~'
    std::string id;
    do {
        id += static_cast<char>('!' + signal % printable);
        signal /= printable;
    } while (signal-- != 0);
    return id;
}

std::uint32_t VcdWriter::add_signal(std::string_view name, std::uint32_t width) {
    assert(now_ < 0 && width >= 1);
    const auto signal = static_cast<std::uint32_t>(widths_.size());
    widths_.push_back(width);
    fmt::format_to(std::back_inserter(text_), "$var wire {} {} {} $end\n", width,
                   identifier(signal), names_.claim_word(one_word(name)));
    return signal;
}

void VcdWriter::begin() {
    text_ += "$upscope $end\n$enddefinitions $end\n";
}

void VcdWriter::move_to(Time at) {
    assert(at >= now_ && at % tick_ == 0);
    if (at == now_) return;
    fmt::format_to(std::back_inserter(text_), "#{}\n", at / tick_);
    now_ = at;
}

void VcdWriter::change(Time at, std::uint32_t signal, char value) {
    move_to(at);
    if (widths_[signal] == 1) {
        text_ += value;
    } else {
        assert(value == 'x');
        text_ += "bx ";
    }
    text_ += identifier(signal);
    text_ += '\n';
}

void VcdWriter::change(Time at, std::uint32_t signal, std::int64_t value) {
    move_to(at);
    text_ += 'b';
    for (std::uint32_t bit = widths_[signal]; bit-- > 0;) {
        const bool is_set = bit > 63 ? value < 0 : (value >> bit & 1) != 0;
        text_ += is_set ? '1' : '0';
    }
    text_ += ' ';
    text_ += identifier(signal);
    text_ += '\n';
}

std::string VcdWriter::finish(Time end) {
    move_to(end);
    return std::move(text_);
}

}  // namespace grafwire
