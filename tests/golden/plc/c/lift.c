// lift: Monte-charge
// Written by grafwire 0.2.0 with: grafwire plc lift.grafcet --to c --modes on --lang en
//
// A GRAFCET (IEC 60848) as a program in C99. A scan is one
// of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
// its parts says which subroutine of the method it is, SBR 0 to SBR 8.
//
// Include this file where the scan is called:
//   lift_inputs in;      fill in the inputs
//   lift_grafcet g;
//   lift_start(&g, &in);       once
//   lift_scan(&g, &in, now);   over and over; now: a clock in us
//   g.outputs               are the outputs
// To try it on scans from a trace of the reference:
//   cc -std=c99 -DGRAFWIRE_MAIN THIS_FILE -o program
//   grafwire run CHART STIMULI --scan 10ms -o trace.csv
//   ./program < trace.csv | diff - trace.csv
//
// Names that are spelt differently in the GRAFCET:
//   arret  arrêt
//   int_2  int

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

// The steps, in the order of the tables.
enum { X0, X1, X2, X10, X11, X12, STEPS, STEP_WORDS = STEPS / 32 + 1 };

// A time condition t1/e/t2: 1 once e has been 1 for t1, 0 once it has been 0 for t2.
typedef struct {
    bool value;
    bool waits;     // e differs from the value
    int64_t since;  // while it waits: the moment since which e differs, in us
} time_condition;

typedef struct {
    bool crate;
    bool top;
    bool arret;
    bool int_2;
    bool Init;  // 1: the initial situation
    bool AUdur;  // 1: no step is active
    bool AUdoux;  // 1: continuous actions are off, the steps stay
} lift_inputs;

typedef struct {
    bool UP;
    bool blow;
    bool lamp;
} lift_outputs;

// All that one scan hands to the next.
typedef struct {
    lift_inputs inputs;
    lift_outputs outputs;
    int64_t now;  // the moment of the scan, in us
    // Tables of the steps, one bit each.
    uint32_t Ts[STEP_WORDS];  // the situation
    uint32_t Tp[STEP_WORDS];  // the situation that the scan began with
    uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];  // to activate, to deactivate
    uint32_t Tf1[STEP_WORDS], Tf0[STEP_WORDS];  // forced to 1, forced to 0
    uint32_t Tpulse[STEP_WORDS];  // activated in this scan
    // The conditions of the transitions.
    struct { bool t0, t1, t2, t_go, t4, t5; } Tt;
    // Edges, 1 in the scan in which they occur.
    struct { bool rise_top, rise_crate; } edge;
    // What the operands of edges were in the scan before.
    struct { bool rise_top, rise_crate; } memory;
    // Time conditions.
    struct { time_condition t1_5s_top_20ms; } time;
    // Internal variables.
    struct { bool full; } vars;
    // Counters.
    struct { int32_t n; } counters;
} lift_grafcet;

static void observe(time_condition *c, bool e, int64_t on_delay, int64_t off_delay, int64_t now) {
    if (e == c->value) {
        c->waits = false;
        return;
    }
    if (!c->waits) {
        c->waits = true;
        c->since = now;
    }
    if (now - c->since < (e ? on_delay : off_delay)) return;
    c->value = e;
    c->waits = false;
}

static inline int32_t within(int32_t low, int32_t value, int32_t high) {
    return value < low ? low : value > high ? high : value;
}

static inline void reset(uint32_t *table, int step) {
    table[step / 32] &= ~((uint32_t)1 << (step % 32));
}

static inline void set(uint32_t *table, int step) {
    table[step / 32] |= (uint32_t)1 << (step % 32);
}

static inline bool is(const uint32_t *table, int step) {
    return ((table[step / 32] >> (step % 32)) & 1u) != 0;
}

static inline void reset_all(uint32_t *table, int first, int last) {
    for (int step = first; step <= last; ++step) reset(table, step);
}

static inline void set_all(uint32_t *table, int first, int last) {
    for (int step = first; step <= last; ++step) set(table, step);
}

// SBR 1: the situation the scan begins with; work tables cleared
static void begin_scan(lift_grafcet *g) {
    for (int w = 0; w < STEP_WORDS; ++w) g->Tp[w] = g->Ts[w];
    for (int w = 0; w < STEP_WORDS; ++w) g->Ta[w] = g->Td[w] = g->Tf1[w] = g->Tf0[w] = 0;
}

// SBR 2: edges
static void find_edges(lift_grafcet *g) {
    // ↑top
    g->edge.rise_top = g->inputs.top && !g->memory.rise_top;
    // memory of ↑top
    g->memory.rise_top = g->inputs.top;
    // ↑crate
    g->edge.rise_crate = g->inputs.crate && !g->memory.rise_crate;
    // memory of ↑crate
    g->memory.rise_crate = g->inputs.crate;
}

// SBR 3: transition conditions
static void test_conditions(lift_grafcet *g) {
    // (0) 0 -> 1 : arrêt
    g->Tt.t0 = g->inputs.arret;
    // (1) 1 -> 2 : /arrêt ⊕ int
    g->Tt.t1 = (!g->inputs.arret) ^ g->inputs.int_2;
    // (2) 2 -> 0 : 1
    g->Tt.t2 = true;
    // (go) 10 -> 11 : ↑crate.[n < 3]
    g->Tt.t_go = g->edge.rise_crate && g->counters.n < 3;
    // (4) 11 -> 12 : 1.5s/top/20ms
    g->Tt.t4 = g->time.t1_5s_top_20ms.value;
    // (5) 12 -> 10 : 1
    g->Tt.t5 = true;
}

// SBR 4: evolution, rules 2 to 5
static void evolve(lift_grafcet *g) {
    // (0) 0 -> 1
    if (is(g->Ts, X0) && g->Tt.t0) {
        set(g->Ta, X1);
        set(g->Td, X0);
    }
    // (1) 1 -> 2
    if (is(g->Ts, X1) && g->Tt.t1) {
        set(g->Ta, X2);
        set(g->Td, X1);
    }
    // (2) 2 -> 0
    if (is(g->Ts, X2) && g->Tt.t2) {
        set(g->Ta, X0);
        set(g->Td, X2);
    }
    // (go) 10 -> 11
    if (is(g->Ts, X10) && g->Tt.t_go) {
        set(g->Ta, X11);
        set(g->Td, X10);
    }
    // (4) 11 -> 12
    if (is(g->Ts, X11) && g->Tt.t4) {
        set(g->Ta, X12);
        set(g->Td, X11);
    }
    // (5) 12 -> 10
    if (is(g->Ts, X12) && g->Tt.t5) {
        set(g->Ta, X10);
        set(g->Td, X12);
    }
    // Ts = Tp . /Td + Ta
    for (int w = 0; w < STEP_WORDS; ++w) g->Ts[w] = (g->Tp[w] & ~g->Td[w]) | g->Ta[w];
    // Init: initial steps
    if (g->inputs.Init) {
        set(g->Ts, X0);
        set(g->Ts, X10);
    }
    // Init: all other steps
    if (g->inputs.Init) {
        reset_all(g->Ts, X1, X2);
        reset_all(g->Ts, X11, X12);
    }
}

// SBR 5: orders and enclosures
static void obey_orders(lift_grafcet *g) {
    // forcing orders of step 1
    if (is(g->Ts, X1)) {
        set_all(g->Tf0, X10, X12);
    }
    // forcing orders of step 2
    if (is(g->Ts, X2)) {
        set(g->Tf1, X10);
        set_all(g->Tf0, X10, X12);
    }
    // Ts = Ts . /Tf0 + Tf1
    for (int w = 0; w < STEP_WORDS; ++w) g->Ts[w] = (g->Ts[w] & ~g->Tf0[w]) | g->Tf1[w];
    // AUdur: every step
    if (g->inputs.AUdur) {
        reset_all(g->Ts, X0, X12);
    }
    // Tpulse = Ts . /Tp
    for (int w = 0; w < STEP_WORDS; ++w) g->Tpulse[w] = g->Ts[w] & ~g->Tp[w];
}

// SBR 5, end: stored actions
static void run_stored_actions(lift_grafcet *g) {
    // full on clearing of (5) 12 -> 10
    if (is(g->Tp, X12) && g->Tt.t5 && !g->inputs.Init) {
        g->vars.full = false;
    }
    // n on activation of step 11
    if (is(g->Tpulse, X11)) {
        g->counters.n = within(0, g->counters.n + 1, 3);
    }
    // full on an event in step 12
    if (is(g->Ts, X12) && g->edge.rise_top) {
        g->vars.full = true;
    }
}

// SBR 6: time conditions
static void observe_times(lift_grafcet *g) {
    // 1.5s/top/20ms
    observe(&g->time.t1_5s_top_20ms, g->inputs.top, 1500000, 20000, g->now);
}

// SBR 8: outputs
static void drive_outputs(lift_grafcet *g) {
    // UP
    g->outputs.UP = is(g->Ts, X11) && !g->inputs.top && !g->inputs.AUdoux;
    // blow
    g->outputs.blow = is(g->Ts, X12) && !g->inputs.AUdoux;
    // lamp
    g->outputs.lamp = is(g->Ts, X1) && !g->inputs.AUdoux;
}

// SBR 0: before the first scan, the initial situation
void lift_start(lift_grafcet *g, const lift_inputs *in) {
    memset(g, 0, sizeof *g);
    g->inputs = *in;
    // initial step 0
    set(g->Ts, X0);
    set(g->Tp, X0);
    // initial step 10
    set(g->Ts, X10);
    set(g->Tp, X10);
    // n
    g->counters.n = 0;
    // memory of ↑top
    g->memory.rise_top = g->inputs.top;
    // memory of ↑crate
    g->memory.rise_crate = g->inputs.crate;
}

// One scan. The clock, in us, never goes back.
void lift_scan(lift_grafcet *g, const lift_inputs *in, int64_t now) {
    g->inputs = *in;
    g->now = now;
    begin_scan(g);
    find_edges(g);
    test_conditions(g);
    evolve(g);
    obey_orders(g);
    run_stored_actions(g);
    observe_times(g);
    drive_outputs(g);
}

#ifdef GRAFWIRE_MAIN

#include <stdio.h>

// Reads a moment in ms, as `0.5`, into us. Whether it is one, and whole in us.
static bool read_moment(int64_t *now) {
    char text[16];
    int decimals = -1;
    if (scanf("%15[0-9.]", text) != 1) return false;
    *now = 0;
    for (const char *at = text; *at != '\0'; ++at) {
        if (*at == '.') {
            if (decimals >= 0) return false;
            decimals = 0;
            continue;
        }
        if (decimals >= 0 && ++decimals > 3) return false;
        *now = 10 * *now + (*at - '0');
    }
    for (decimals = decimals < 0 ? 0 : decimals; decimals < 3; ++decimals) *now *= 10;
    return true;
}

static void write_moment(int64_t now) {
    printf("%lld", (long long)(now / 1000));
    if (now % 1000 == 0) return;
    int fraction = (int)(now % 1000);
    int digits = 3;
    for (; fraction % 10 == 0; fraction /= 10) --digits;
    printf(".%0*d", digits, fraction);
}

static int skip_line(void) {
    int c = getchar();
    while (c != '\n' && c != EOF) c = getchar();
    return c;
}

// The columns of inputs; Init, AUdur and AUdoux are always there.
enum { INPUT_COLUMNS = 7 };

static bool read_scan(int64_t *now, int *values) {
    char bit[2];
    if (!read_moment(now)) return false;
    for (int i = 0; i < INPUT_COLUMNS; ++i) {
        if (scanf(",%1[01]", bit) != 1) return false;
        values[i] = bit[0] == '1';
    }
    skip_line();
    return true;
}

static void write_row(const lift_grafcet *g, int64_t now, const int *values) {
    write_moment(now);
    for (int i = 0; i < INPUT_COLUMNS; ++i) printf(",%d", values[i]);
    for (int step = 0; step < STEPS; ++step) {
        printf(",%d", (int)(g->Ts[step / 32] >> (step % 32) & 1u));
    }
    printf(",%d", g->outputs.UP);
    printf(",%d", g->outputs.blow);
    printf(",%d", g->outputs.lamp);
    printf(",%d", g->vars.full);
    printf(",%lld", (long long)g->counters.n);
    putchar('\n');
}

// Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and
// further columns, are passed over. Writes the trace in the columns of the reference.
int main(void) {
    lift_grafcet g;
    lift_inputs in;
    int values[INPUT_COLUMNS];
    int64_t now;
    memset(&in, 0, sizeof in);
    fputs("time_ms,crate,top,arrêt,int,Init,AUdur,AUdoux,X0,X1,X2,X10,X11,X12,", stdout);
    fputs("UP,blow,lamp,full,n", stdout);
    putchar('\n');
    skip_line();
    for (long row = 2; ; ++row) {
        const int c = getchar();
        if (c == EOF) return 0;
        ungetc(c, stdin);
        if (!read_scan(&now, values)) {
            fprintf(stderr, "line %ld: expected a moment in ms, whole in us, and %d inputs\n",
                    row, INPUT_COLUMNS);
            return 1;
        }
        in.crate = values[0] != 0;
        in.top = values[1] != 0;
        in.arret = values[2] != 0;
        in.int_2 = values[3] != 0;
        in.Init = values[4] != 0;
        in.AUdur = values[5] != 0;
        in.AUdoux = values[6] != 0;
        if (row == 2) lift_start(&g, &in);
        lift_scan(&g, &in, now);
        write_row(&g, now, values);
    }
}

#endif
