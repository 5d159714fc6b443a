#pragma once

#include <string_view>

namespace grafwire::python {

// The parts of a program in Python that are the same for every chart.

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
    """The steps from first to last, both included, as one table."""
    return (last << 1) - first
)";

inline constexpr std::string_view time_class = R"(

class TimeCondition:
    """t1/e/t2: True once e has been True for t1, False once it has been False for t2."""

    def __init__(self):
        self.value = False
        self.since = None  # the moment since which e differs from the value

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
    """A moment in us, from one in ms as `0.5`."""
    moment = Decimal(text) * 1000
    if moment < 0 or moment % 1 != 0:
        raise ValueError
    return int(moment)


def milliseconds(moment):
    return f"{Decimal(moment) / 1000:f}"


def run(lines, out):
    """Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and further
    columns, are passed over. Writes the trace in the columns of the reference."""
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
            sys.exit(f"line {number}: expected a moment in ms, whole in us, and "
                     f"{INPUT_COLUMNS} inputs")
        inputs = inputs_of(values)
        if chart is None:
            chart = Grafcet(inputs)
        chart.scan(inputs, now)
        cells = [int(value) for value in values + values_of(chart)]
        print(milliseconds(now), *cells, sep=",", file=out)


if __name__ == "__main__":
    sys.stdin.reconfigure(encoding="utf-8")
    sys.stdout.reconfigure(encoding="utf-8", newline="\n")
    run(sys.stdin, sys.stdout)
)";

}  // namespace grafwire::python
