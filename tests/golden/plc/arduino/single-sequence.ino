// single_sequence: Séquence unique
// Written by grafwire 0.2.0 with: grafwire plc single-sequence.grafcet --to arduino --modes on --lang en
//
// A GRAFCET (IEC 60848) as a sketch for Arduino boards. A scan is one
// of the table method (Cordier, "Méthode d'implémentation du GRAFCET", 1998); each of
// its parts says which subroutine of the method it is, SBR 0 to SBR 8.

#include <Arduino.h>
#include <stdint.h>
#include <string.h>

// The pins: change them to suit the wiring.
// An input is 1 where its pin is HIGH. A contact to 5 V needs a resistor to ground: a pin that
// is left open is read as anything (--pull-up: contacts to ground, without resistors).
// Init, AUdur and AUdoux are contacts to ground, with the pull-up resistors of the board: left
// open they are 0, and the chart runs.
const uint8_t in_m = 2;
const uint8_t in_a = 3;
const uint8_t in_b = 4;
const uint8_t in_Init = 5;
const uint8_t in_AUdur = 6;
const uint8_t in_AUdoux = 7;

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

static single_sequence_grafcet chart;
static single_sequence_inputs inputs;

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

// micros() starts again at 0 after 71 minutes; this clock does not, if it is read more often.
static int64_t clock_now() {
    static uint32_t last = 0;
    static int64_t sum = 0;
    const uint32_t now = micros();
    sum += (uint32_t)(now - last);
    last = now;
    return sum;
}

static void read_inputs() {
    inputs.m = digitalRead(in_m) == HIGH;
    inputs.a = digitalRead(in_a) == HIGH;
    inputs.b = digitalRead(in_b) == HIGH;
    inputs.Init = digitalRead(in_Init) == LOW;
    inputs.AUdur = digitalRead(in_AUdur) == LOW;
    inputs.AUdoux = digitalRead(in_AUdoux) == LOW;
}

static void write_outputs() {
}

void setup() {
    pinMode(in_m, INPUT);
    pinMode(in_a, INPUT);
    pinMode(in_b, INPUT);
    pinMode(in_Init, INPUT_PULLUP);
    pinMode(in_AUdur, INPUT_PULLUP);
    pinMode(in_AUdoux, INPUT_PULLUP);
    // Until the pull-up resistors have charged the wires.
    delay(1);
    read_inputs();
    single_sequence_start(&chart, &inputs);
}

// One scan.
void loop() {
    read_inputs();
    single_sequence_scan(&chart, &inputs, clock_now());
    write_outputs();
}
