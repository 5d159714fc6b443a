# -*- coding: utf-8 -*-
#
# single_sequence : Séquence unique
# Écrit par grafwire 0.2.0 avec : grafwire plc single-sequence.grafcet --to python --modes on --lang fr
#
# GRAFCET (CEI 60848), programme en Python 3. Une scrutation est
# celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
# chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.
#
# Pour l'utiliser :
#   inputs = Inputs(...)       celles qui ne sont pas nommées valent False
#   chart = Grafcet(inputs)
#   chart.scan(inputs, now)    en boucle ; now : une horloge en us
#   chart.outputs
# Pour l'essayer sur les scrutations d'une trace de la référence :
#   grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv
#   python3 CE_FICHIER < trace.csv | diff - trace.csv

import sys
from decimal import Decimal, InvalidOperation
from types import SimpleNamespace

# Les étapes, comme bits des tables.
X0 = 1 << 0
X1 = 1 << 1
X2 = 1 << 2
STEP_COUNT = 3


def is_in(step, table):
    return table & step != 0


def through(first, last):
    """Les étapes de first à last, l'une et l'autre comprises, en une table."""
    return (last << 1) - first


class Inputs(SimpleNamespace):
    m = False
    a = False
    b = False
    Init = False
    AUdur = False
    AUdoux = False


class Grafcet:
    # SBR 0 : avant la première scrutation, situation initiale
    def __init__(self, inputs):
        self.inputs = inputs
        self.now = 0  # instant de la scrutation, en us
        self.Ts = 0  # situation
        self.Tp = 0  # situation en début de scrutation
        self.Ta = self.Td = 0  # à activer, à désactiver
        # Réceptivités des transitions.
        self.Tt = SimpleNamespace(t_0=False, t_1=False, t_2=False)
        # étape initiale 0
        self.Ts |= X0
        self.Tp |= X0

    # SBR 1 : situation en début de scrutation ; tables de travail à 0
    def begin_scan(self):
        self.Tp = self.Ts
        self.Ta = self.Td = 0

    # SBR 3 : réceptivités
    def test_conditions(self):
        # (0) 0 -> 1 : m
        self.Tt.t_0 = self.inputs.m
        # (1) 1 -> 2 : a
        self.Tt.t_1 = self.inputs.a
        # (2) 2 -> 0 : b
        self.Tt.t_2 = self.inputs.b

    # SBR 4 : évolution, règles 2 à 5
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
        # Init : étapes initiales
        if self.inputs.Init:
            self.Ts |= X0
        # Init : toutes les autres étapes
        if self.inputs.Init:
            self.Ts &= ~through(X1, X2)

    # SBR 5 : forçages et encapsulations
    def obey_orders(self):
        # AUdur : toutes les étapes
        if self.inputs.AUdur:
            self.Ts &= ~through(X0, X2)

    # Une scrutation. L'horloge, en us, ne recule jamais.
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
INPUT_COLUMNS = 6  # avec Init, AUdur et AUdoux


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
    """Un instant en us, à partir de ms comme `0.5`."""
    moment = Decimal(text) * 1000
    if moment < 0 or moment % 1 != 0:
        raise ValueError
    return int(moment)


def milliseconds(moment):
    return f"{Decimal(moment) / 1000:f}"


def run(lines, out):
    """Lit une ligne par scrutation : l'instant en ms, les entrées à 0 ou 1. La première ligne et
    les colonnes en plus sont ignorées. Écrit la trace dans les colonnes de la référence."""
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
            sys.exit(f"ligne {number} : instant en ms attendu (entier en us), puis "
                     f"{INPUT_COLUMNS} entrées")
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
