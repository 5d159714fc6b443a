# -*- coding: utf-8 -*-
#
# single_sequence: Séquence unique
# Written by grafwire 0.2.0 with: grafwire plc single-sequence.grafcet --to python --modes on --lang en
#
# A GRAFCET (IEC 60848) as a program in Python 3. A scan is one
# of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
# its parts says which subroutine of the method it is, SBR 0 to SBR 8.
#
# To use it:
#   inputs = Inputs(...)       those that are not named are False
#   chart = Grafcet(inputs)
#   chart.scan(inputs, now)    over and over; now: a clock in us
#   chart.outputs
# To try it on scans from a trace of the reference:
#   grafwire run CHART STIMULI --scan 10ms -o trace.csv
#   python3 THIS_FILE < trace.csv | diff - trace.csv

import sys
from decimal import Decimal, InvalidOperation
from types import SimpleNamespace

# The steps, as bits of the tables.
X0 = 1 << 0
X1 = 1 << 1
X2 = 1 << 2
STEP_COUNT = 3


def is_in(step, table):
    return table & step != 0


def through(first, last):
    """The steps from first to last, both included, as one table."""
    return (last << 1) - first


class Inputs(SimpleNamespace):
    m = False
    a = False
    b = False
    Init = False
    AUdur = False
    AUdoux = False


class Grafcet:
    # SBR 0: before the first scan, the initial situation
    def __init__(self, inputs):
        self.inputs = inputs
        self.now = 0  # the moment of the scan, in us
        self.Ts = 0  # the situation
        self.Tp = 0  # the situation that the scan began with
        self.Ta = self.Td = 0  # to activate, to deactivate
        # The conditions of the transitions.
        self.Tt = SimpleNamespace(t_0=False, t_1=False, t_2=False)
        # initial step 0
        self.Ts |= X0
        self.Tp |= X0

    # SBR 1: the situation the scan begins with; work tables cleared
    def begin_scan(self):
        self.Tp = self.Ts
        self.Ta = self.Td = 0

    # SBR 3: transition conditions
    def test_conditions(self):
        # (0) 0 -> 1 : m
        self.Tt.t_0 = self.inputs.m
        # (1) 1 -> 2 : a
        self.Tt.t_1 = self.inputs.a
        # (2) 2 -> 0 : b
        self.Tt.t_2 = self.inputs.b

    # SBR 4: evolution, rules 2 to 5
    def evolve(self):
        # (0) 0 -> 1
        if is_in(X0, self.Ts) and self.Tt.t_0:
            self.Ta |= X1
            self.Td |= X0
        # (1) 1 -> 2
        if is_in(X1, self.Ts) and self.Tt.t_1:
            self.Ta |= X2
            self.Td |= X1
        # (2) 2 -> 0
        if is_in(X2, self.Ts) and self.Tt.t_2:
            self.Ta |= X0
            self.Td |= X2
        # Ts = Tp . /Td + Ta
        self.Ts = self.Tp & ~self.Td | self.Ta
        # Init: initial steps
        if self.inputs.Init:
            self.Ts |= X0
        # Init: all other steps
        if self.inputs.Init:
            self.Ts &= ~through(X1, X2)

    # SBR 5: orders and enclosures
    def obey_orders(self):
        # AUdur: every step
        if self.inputs.AUdur:
            self.Ts &= ~through(X0, X2)

    # One scan. The clock, in us, never goes back.
    def scan(self, inputs, now):
        self.inputs = inputs
        self.now = now
        self.begin_scan()
        self.test_conditions()
        self.evolve()
        self.obey_orders()


HEADING = (
    "time_ms,m,a,b,Init,AUdur,AUdoux,X0,X1,X2"
)
INPUT_COLUMNS = 6  # Init, AUdur and AUdoux included


def inputs_of(values):
    return Inputs(
        m=values[0],
        a=values[1],
        b=values[2],
        Init=values[3],
        AUdur=values[4],
        AUdoux=values[5],
    )


def values_of(chart):
    return [
        *(is_in(1 << step, chart.Ts) for step in range(STEP_COUNT)),
    ]


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
    with open(0, encoding="utf-8", closefd=False) as scans:
        with open(1, "w", encoding="utf-8", newline="\n", closefd=False) as trace:
            run(scans, trace)
