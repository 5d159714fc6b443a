// A run change by change (VCD), and how a viewer is to show it.
//
// A VCD text declares its signals under short identifiers of printable characters, then holds only
// changes: of the rows 0, 0, 1 of a column the first (its value from then on) and the third.
// Counters are vectors in two's complement, so that a viewer shows them as signed numbers.
//
// IEEE 1364 lets a name be any printable ASCII; GTKWave 3.3.118 takes fewer: a text with one name
// beyond ASCII has "no symbols" for it, a name with `:` or `]`, or with `[` in front, is not found,
// and one with `.`, or with `#` in front, gets another spelling. So names are written in what it
// reads, and comments say what they stand for; at the end of the text, since one beyond ASCII among
// the declarations ends them for it as well.

#include "trace/waveform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// The coarsest timescale in which every time in the trace is a whole number.
Time tick_of(const Trace& trace) {
    for (const Time tick : {millisecond, microsecond, nanosecond}) {
        bool fits = true;
        for (const Time at : trace.times) fits = fits && at % tick == 0;
        if (fits) return tick;
    }
    return 1;
}

/// A name as one word that viewers read. A leading `$` would make it a keyword.
std::string one_word(std::string_view name) {
    if (!is_ascii(name)) return ascii_word(name);
    std::string word(name);
    for (char& c : word) {
        const bool means_something = std::string_view("[]:.#").find(c) != std::string_view::npos;
        if (c <= ' ' || c == '\x7f' || means_something) c = '_';
    }
    if (word.empty()) return "_";
    if (word.front() == '$') word.front() = '_';
    return word;
}

/// A name within a comment, which ends at the word `$end`.
std::string in_comment(std::string_view name) {
    std::string text(name);
    std::replace(text.begin(), text.end(), '$', '_');
    std::replace_if(
        text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
    return text;
}

std::string_view timescale(Time tick) {
    if (tick == millisecond) return "1 ms";
    if (tick == microsecond) return "1 us";
    if (tick == nanosecond) return "1 ns";
    assert(tick == 1);
    return "1 ps";
}

}  // namespace

VcdWriter::VcdWriter(std::string_view scope, Time tick) : scope_(one_word(scope)), tick_(tick) {
    text_ += fmt::format("$version {} $end\n$timescale {} $end\n", program_and_version(),
                         timescale(tick));
    tell_apart(scope, scope_);
    text_ += fmt::format("$scope module {} $end\n", scope_);
}

/// Where a name is written otherwise than in the chart.
void VcdWriter::tell_apart(std::string_view name, std::string_view written) {
    if (name == written) return;
    comments_ += fmt::format("$comment {} is {} $end\n", written, in_comment(name));
}

/// `!`, `"`, … `~`, `!!`, `"!`, …: a number in base 94 whose digits count from 1, so that all
/// differ.
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
    written_.push_back(names_.claim_word(one_word(name)));
    tell_apart(name, written_.back());
    text_ += fmt::format("$var wire {} {} {} $end\n", width, identifier(signal), written_.back());
    return signal;
}

std::string VcdWriter::shown_name(std::uint32_t signal) const {
    std::string name = scope_ + "." + written_[signal];
    if (widths_[signal] > 1) name += fmt::format("[{}:0]", widths_[signal] - 1);
    return name;
}

void VcdWriter::begin() {
    text_ += "$upscope $end\n$enddefinitions $end\n";
}

/// A line of its own says the time of all changes that follow it.
void VcdWriter::move_to(Time at) {
    assert(at >= now_ && at % tick_ == 0);
    if (at == now_) return;
    text_ += fmt::format("#{}\n", at / tick_);
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
    return std::move(text_) + comments_;
}

void Waveform::add(const Trace::Column& column, const VcdWriter& writer, std::uint32_t signal) {
    signals.push_back({column.kind, writer.shown_name(signal), column.width > 1});
}

Waveform waveform_of(const Trace& trace, std::string_view scope) {
    VcdWriter writer(scope, tick_of(trace));
    Waveform waveform;
    for (const Trace::Column& column : trace.columns) {
        waveform.add(column, writer, writer.add_signal(column.name, column.width));
    }
    writer.begin();
    const std::size_t count = trace.columns.size();
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        const std::int64_t* values = trace.values.data() + row * count;
        const Time at = trace.times[row];
        for (std::size_t c = 0; c < count; ++c) {
            if (row != 0 && values[c] == (values - count)[c]) continue;
            const auto signal = static_cast<std::uint32_t>(c);
            if (values[c] == Trace::unknown) {
                writer.change(at, signal, 'x');
            } else if (trace.columns[c].width == 1) {
                writer.change(at, signal, values[c] == 0 ? '0' : '1');
            } else {
                writer.change(at, signal, values[c]);
            }
        }
    }
    waveform.vcd = writer.finish(trace.times.empty() ? 0 : trace.times.back());
    return waveform;
}

namespace {

// Of the flags of a line in GTKWave's save file (GTKWave 3.3 user's guide, appendix C).
constexpr std::string_view as_bit = "@28";
constexpr std::string_view as_signed_number = "@420";
constexpr std::string_view begin_group = "@800200";
constexpr std::string_view end_group = "@1000200";

constexpr std::pair<Trace::Column::Kind, std::string_view> groups[] = {
    {Trace::Column::Kind::input, "inputs"},
    {Trace::Column::Kind::step, "steps"},
    {Trace::Column::Kind::output, "outputs"},
    {Trace::Column::Kind::internal, "vars and counters"},
};

}  // namespace

std::string write_gtkw(const Waveform& waveform, std::string_view vcd_file) {
    std::string text =
        fmt::format("[*] {}\n[dumpfile] \"{}\"\n[timestart] 0\n", program_and_version(), vcd_file);
    for (const auto& [kind, title] : groups) {
        const auto is_of_group = [kind = kind](const Waveform::Signal& s) {
            return s.kind == kind;
        };
        if (std::none_of(waveform.signals.begin(), waveform.signals.end(), is_of_group)) continue;
        text += fmt::format("{}\n-{}\n", begin_group, title);
        for (const Waveform::Signal& signal : waveform.signals) {
            if (!is_of_group(signal)) continue;
            text +=
                fmt::format("{}\n{}\n", signal.is_number ? as_signed_number : as_bit, signal.name);
        }
        text += fmt::format("{}\n-{}\n", end_group, title);
    }
    return text;
}

}  // namespace grafwire
