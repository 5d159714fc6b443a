#pragma once

#include <string_view>

namespace grafwire::python {

// The parts of a program in Python that are the same for every chart. An @ stands for a text in the
// language of the reader (with_texts).

inline constexpr std::string_view imports = R"(
import sys
from decimal import Decimal, InvalidOperation
from types import SimpleNamespace
)";

inline constexpr std::string_view is_in_function = R"(

def is_in(step, table):
    return table & step != 0
)";

inline constexpr std::string_view through_function = R"(

def through(first, last):
    """@steps_through"""
    return (last << 1) - first
)";

inline constexpr std::string_view time_class = R"(

class TimeCondition:
    """@time_condition"""

    def __init__(self):
        self.value = False
        self.since = None  # @differs_since

    def observe(self, e, on_delay, off_delay, now):
        if e == self.value:
            self.since = None
            return
        if self.since is None:
            self.since = now
        if now - self.since >= (on_delay if e else off_delay):
            self.value = e
            self.since = None
)";

inline constexpr std::string_view reading_and_writing = R"(

def microseconds(text):
    """@from_ms"""
    moment = Decimal(text) * 1000
    if moment < 0 or moment % 1 != 0:
        raise ValueError
    return int(moment)


def milliseconds(moment):
    return f"{Decimal(moment) / 1000:f}"


def run(lines, out):
    """@reads_scans"""
    print(HEADING, file=out)
    chart = None
    next(lines, None)
    for number, line in enumerate(lines, 2):
        moment, *bits = line.rstrip("\n").split(",")
        try:
            now = microseconds(moment)
            values = [("0", "1").index(bit) == 1 for bit in bits[:INPUT_COLUMNS]]
            if len(values) != INPUT_COLUMNS:
                raise ValueError
        except (InvalidOperation, ValueError):
            sys.exit(f"@bad_line")
        inputs = inputs_of(values)
        if chart is None:
            chart = Grafcet(inputs)
        chart.scan(inputs, now)
        cells = [int(value) for value in values + values_of(chart)]
        print(milliseconds(now), *cells, sep=",", file=out)


if __name__ == "__main__":
    with open(0, encoding="utf-8", closefd=False) as scans:
        with open(1, "w", encoding="utf-8", newline="\n", closefd=False) as trace:
            run(scans, trace)
)";

}  // namespace grafwire::python
