// single_sequence: Séquence unique
// Written by grafwire 0.2.0 with: grafwire plc single-sequence.grafcet --to c --modes on --lang en
//
// A GRAFCET (IEC 60848) as a program in C99. A scan is one
// of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
// its parts says which subroutine of the method it is, SBR 0 to SBR 8.
//
// Include this file where the scan is called:
//   single_sequence_inputs in;      fill in the inputs
//   single_sequence_grafcet g;
//   single_sequence_start(&g, &in);       once
//   single_sequence_scan(&g, &in, now);   over and over; now: a clock in us
//   g.outputs               are the outputs
// To try it on scans from a trace of the reference:
//   cc -std=c99 -DGRAFWIRE_MAIN THIS_FILE -o program
//   grafwire run CHART STIMULI --scan 10ms -o trace.csv
//   ./program < trace.csv | diff - trace.csv

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

// The steps, in the order of the tables.
enum { X0, X1, X2, STEPS, STEP_WORDS = STEPS / 32 + 1 };

typedef struct {
    bool m;
    bool a;
    bool b;
    bool Init;  // 1: the initial situation
    bool AUdur;  // 1: no step is active
    bool AUdoux;  // 1: continuous actions are off, the steps stay
} single_sequence_inputs;

typedef struct {
    bool none;
} single_sequence_outputs;

// All that one scan hands to the next.
typedef struct {
    single_sequence_inputs inputs;
    single_sequence_outputs outputs;
    int64_t now;  // the moment of the scan, in us
    // Tables of the steps, one bit each.
    uint32_t Ts[STEP_WORDS];  // the situation
    uint32_t Tp[STEP_WORDS];  // the situation that the scan began with
    uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];  // to activate, to deactivate
    // The conditions of the transitions.
    struct { bool t_0, t_1, t_2; } Tt;
} single_sequence_grafcet;

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

// SBR 1: the situation the scan begins with; work tables cleared
static void begin_scan(single_sequence_grafcet *g) {
    for (int w = 0; w < STEP_WORDS; ++w) g->Tp[w] = g->Ts[w];
    for (int w = 0; w < STEP_WORDS; ++w) g->Ta[w] = g->Td[w] = 0;
}

// SBR 3: transition conditions
static void test_conditions(single_sequence_grafcet *g) {
    // (0) 0 -> 1 : m
    g->Tt.t_0 = g->inputs.m;
    // (1) 1 -> 2 : a
    g->Tt.t_1 = g->inputs.a;
    // (2) 2 -> 0 : b
    g->Tt.t_2 = g->inputs.b;
}

// SBR 4: evolution, rules 2 to 5
static void evolve(single_sequence_grafcet *g) {
    // (0) 0 -> 1
    if (is(g->Ts, X0) && g->Tt.t_0) {
        set(g->Ta, X1);
        set(g->Td, X0);
    }
    // (1) 1 -> 2
    if (is(g->Ts, X1) && g->Tt.t_1) {
        set(g->Ta, X2);
        set(g->Td, X1);
    }
    // (2) 2 -> 0
    if (is(g->Ts, X2) && g->Tt.t_2) {
        set(g->Ta, X0);
        set(g->Td, X2);
    }
    // Ts = Tp . /Td + Ta
    for (int w = 0; w < STEP_WORDS; ++w) g->Ts[w] = (g->Tp[w] & ~g->Td[w]) | g->Ta[w];
    // Init: initial steps
    if (g->inputs.Init) {
        set(g->Ts, X0);
    }
    // Init: all other steps
    if (g->inputs.Init) {
        reset_all(g->Ts, X1, X2);
    }
}

// SBR 5: orders and enclosures
static void obey_orders(single_sequence_grafcet *g) {
    // AUdur: every step
    if (g->inputs.AUdur) {
        reset_all(g->Ts, X0, X2);
    }
}

// SBR 0: before the first scan, the initial situation
void single_sequence_start(single_sequence_grafcet *g, const single_sequence_inputs *in) {
    memset(g, 0, sizeof *g);
    g->inputs = *in;
    // initial step 0
    set(g->Ts, X0);
    set(g->Tp, X0);
}

// One scan. The clock, in us, never goes back.
void single_sequence_scan(single_sequence_grafcet *g, const single_sequence_inputs *in, int64_t
        now) {
    g->inputs = *in;
    g->now = now;
    begin_scan(g);
    test_conditions(g);
    evolve(g);
    obey_orders(g);
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
enum { INPUT_COLUMNS = 6 };

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

static void write_row(const single_sequence_grafcet *g, int64_t now, const int *values) {
    write_moment(now);
    for (int i = 0; i < INPUT_COLUMNS; ++i) printf(",%d", values[i]);
    for (int step = 0; step < STEPS; ++step) {
        printf(",%d", (int)(g->Ts[step / 32] >> (step % 32) & 1u));
    }
    putchar('\n');
}

// Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and
// further columns, are passed over. Writes the trace in the columns of the reference.
int main(void) {
    single_sequence_grafcet g;
    single_sequence_inputs in;
    int values[INPUT_COLUMNS];
    int64_t now;
    memset(&in, 0, sizeof in);
    fputs("time_ms,m,a,b,Init,AUdur,AUdoux,X0,X1,X2", stdout);
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
        in.m = values[0] != 0;
        in.a = values[1] != 0;
        in.b = values[2] != 0;
        in.Init = values[3] != 0;
        in.AUdur = values[4] != 0;
        in.AUdoux = values[5] != 0;
        if (row == 2) single_sequence_start(&g, &in);
        single_sequence_scan(&g, &in, now);
        write_row(&g, now, values);
    }
}

#endif
