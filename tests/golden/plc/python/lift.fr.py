# -*- coding: utf-8 -*-
#
# lift : Monte-charge
# Écrit par grafwire 0.2.0 avec : grafwire plc lift.grafcet --to python --modes on --lang fr
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
#
# Noms écrits autrement dans le GRAFCET :
#   arret  arrêt

import sys
from decimal import Decimal, InvalidOperation
from types import SimpleNamespace

# Les étapes, comme bits des tables.
X0 = 1 << 0
X1 = 1 << 1
X2 = 1 << 2
X10 = 1 << 3
X11 = 1 << 4
X12 = 1 << 5
STEP_COUNT = 6


def is_in(step, table):
    return table & step != 0


def through(first, last):
    """Les étapes de first à last, l'une et l'autre comprises, en une table."""
    return (last << 1) - first


class TimeCondition:
    """t1/e/t2 : True quand e est True depuis t1, False quand e est False depuis t2."""

    def __init__(self):
        self.value = False
        self.since = None  # instant depuis lequel e diffère de la valeur

    def observe(self, e, on_delay, off_delay, now):
        if e == self.value:
            self.since = None
            return
        if self.since is None:
            self.since = now
        if now - self.since >= (on_delay if e else off_delay):
            self.value = e
            self.since = None


class Inputs(SimpleNamespace):
    crate = False
    top = False
    arret = False
    int = False
    Init = False
    AUdur = False
    AUdoux = False


class Grafcet:
    # SBR 0 : avant la première scrutation, situation initiale
    def __init__(self, inputs):
        self.inputs = inputs
        self.now = 0  # instant de la scrutation, en us
        # Sorties.
        self.outputs = SimpleNamespace(UP=False, blow=False, lamp=False)
        self.Ts = 0  # situation
        self.Tp = 0  # situation en début de scrutation
        self.Ta = self.Td = 0  # à activer, à désactiver
        self.Tf1 = self.Tf0 = 0  # forcées à 1, forcées à 0
        self.Tpulse = 0  # activées dans cette scrutation
        # Réceptivités des transitions.
        self.Tt = SimpleNamespace(t0=False, t1=False, t2=False, t_go=False, t4=False, t5=False)
        # Fronts, True dans la scrutation où ils se produisent.
        self.edge = SimpleNamespace(rise_top=False, rise_crate=False)
        # Valeurs des opérandes des fronts à la scrutation précédente.
        self.memory = SimpleNamespace(rise_top=False, rise_crate=False)
        # Temporisations.
        self.time = SimpleNamespace(t1_5s_top_20ms=TimeCondition())
        # Variables internes.
        self.vars = SimpleNamespace(full=False)
        # Compteurs.
        self.counters = SimpleNamespace()
        # étape initiale 0
        self.Ts |= X0
        self.Tp |= X0
        # étape initiale 10
        self.Ts |= X10
        self.Tp |= X10
        # n
        self.counters.n = max(0, min(0, 3))
        # mémoire de ↑top
        self.memory.rise_top = self.inputs.top
        # mémoire de ↑crate
        self.memory.rise_crate = self.inputs.crate

    # SBR 1 : situation en début de scrutation ; tables de travail à 0
    def begin_scan(self):
        self.Tp = self.Ts
        self.Ta = self.Td = self.Tf1 = self.Tf0 = 0

    # SBR 2 : fronts
    def find_edges(self):
        # ↑top
        self.edge.rise_top = self.inputs.top and not self.memory.rise_top
        # mémoire de ↑top
        self.memory.rise_top = self.inputs.top
        # ↑crate
        self.edge.rise_crate = self.inputs.crate and not self.memory.rise_crate
        # mémoire de ↑crate
        self.memory.rise_crate = self.inputs.crate

    # SBR 3 : réceptivités
    def test_conditions(self):
        # (0) 0 -> 1 : arrêt
        self.Tt.t0 = self.inputs.arret
        # (1) 1 -> 2 : /arrêt ⊕ int
        self.Tt.t1 = (not self.inputs.arret) ^ self.inputs.int
        # (2) 2 -> 0 : 1
        self.Tt.t2 = True
        # (go) 10 -> 11 : ↑crate.[n < 3]
        self.Tt.t_go = self.edge.rise_crate and self.counters.n < 3
        # (4) 11 -> 12 : 1.5s/top/20ms
        self.Tt.t4 = self.time.t1_5s_top_20ms.value
        # (5) 12 -> 10 : 1
        self.Tt.t5 = True

    # SBR 4 : évolution, règles 2 à 5
    def evolve(self):
        # (0) 0 -> 1
        if is_in(X0, self.Ts) and self.Tt.t0:
            self.Ta |= X1
            self.Td |= X0
        # (1) 1 -> 2
        if is_in(X1, self.Ts) and self.Tt.t1:
            self.Ta |= X2
            self.Td |= X1
        # (2) 2 -> 0
        if is_in(X2, self.Ts) and self.Tt.t2:
            self.Ta |= X0
            self.Td |= X2
        # (go) 10 -> 11
        if is_in(X10, self.Ts) and self.Tt.t_go:
            self.Ta |= X11
            self.Td |= X10
        # (4) 11 -> 12
        if is_in(X11, self.Ts) and self.Tt.t4:
            self.Ta |= X12
            self.Td |= X11
        # (5) 12 -> 10
        if is_in(X12, self.Ts) and self.Tt.t5:
            self.Ta |= X10
            self.Td |= X12
        # Ts = Tp . /Td + Ta
        self.Ts = self.Tp & ~self.Td | self.Ta
        # Init : étapes initiales
        if self.inputs.Init:
            self.Ts |= X0 | X10
        # Init : toutes les autres étapes
        if self.inputs.Init:
            self.Ts &= ~(through(X1, X2) | through(X11, X12))

    # SBR 5 : forçages et encapsulations
    def obey_orders(self):
        # ordres de forçage de l'étape 1
        if is_in(X1, self.Ts):
            self.Tf0 |= through(X10, X12)
        # ordres de forçage de l'étape 2
        if is_in(X2, self.Ts):
            self.Tf1 |= X10
            self.Tf0 |= through(X10, X12)
        # Ts = Ts . /Tf0 + Tf1
        self.Ts = self.Ts & ~self.Tf0 | self.Tf1
        # AUdur : toutes les étapes
        if self.inputs.AUdur:
            self.Ts &= ~through(X0, X12)
        # Tpulse = Ts . /Tp
        self.Tpulse = self.Ts & ~self.Tp

    # SBR 5, fin : actions mémorisées
    def run_stored_actions(self):
        # full au franchissement de (5) 12 -> 10
        if is_in(X12, self.Tp) and self.Tt.t5 and not self.inputs.Init:
            self.vars.full = False
        # n à l'activation de l'étape 11
        if is_in(X11, self.Tpulse):
            self.counters.n = max(0, min(self.counters.n + 1, 3))
        # full sur événement à l'étape 12
        if is_in(X12, self.Ts) and self.edge.rise_top:
            self.vars.full = True

    # SBR 6 : temporisations
    def observe_times(self):
        # 1.5s/top/20ms
        self.time.t1_5s_top_20ms.observe(self.inputs.top, 1500000, 20000, self.now)

    # SBR 8 : sorties
    def drive_outputs(self):
        # UP
        self.outputs.UP = is_in(X11, self.Ts) and not self.inputs.top and not self.inputs.AUdoux
        # blow
        self.outputs.blow = is_in(X12, self.Ts) and not self.inputs.AUdoux
        # lamp
        self.outputs.lamp = is_in(X1, self.Ts) and not self.inputs.AUdoux

    # Une scrutation. L'horloge, en us, ne recule jamais.
    def scan(self, inputs, now):
        self.inputs = inputs
        self.now = now
        self.begin_scan()
        self.find_edges()
        self.test_conditions()
        self.evolve()
        self.obey_orders()
        self.run_stored_actions()
        self.observe_times()
        self.drive_outputs()


HEADING = (
    "time_ms,crate,top,arrêt,int,Init,AUdur,AUdoux,X0,X1,X2,X10,X11,X12,"
    "UP,blow,lamp,full,n"
)
INPUT_COLUMNS = 7  # avec Init, AUdur et AUdoux


def inputs_of(values):
    return Inputs(
        crate=values[0],
        top=values[1],
        arret=values[2],
        int=values[3],
        Init=values[4],
        AUdur=values[5],
        AUdoux=values[6],
    )


def values_of(chart):
    return [
        *(is_in(1 << step, chart.Ts) for step in range(STEP_COUNT)),
        chart.outputs.UP,
        chart.outputs.blow,
        chart.outputs.lamp,
        chart.vars.full,
        chart.counters.n,
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
