// single_sequence : Séquence unique
// Écrit par grafwire 0.2.0 avec : grafwire plc single-sequence.grafcet --to arduino --modes on --lang fr
//
// GRAFCET (CEI 60848), croquis pour cartes Arduino. Une scrutation est
// celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
// chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.

#include <Arduino.h>
#include <stdint.h>
#include <string.h>

// Les broches : à adapter au câblage.
// Une entrée vaut 1 quand sa broche est HIGH. Un contact vers le 5 V demande une résistance
// vers la masse : une broche en l'air donne une valeur quelconque (--pull-up : contacts vers
// la masse, sans résistance).
// Init, AUdur et AUdoux sont des contacts vers la masse, avec les résistances de tirage de la
// carte : non raccordés, ils valent 0 et le GRAFCET évolue.
const uint8_t in_m = 2;
const uint8_t in_a = 3;
const uint8_t in_b = 4;
const uint8_t in_Init = 5;
const uint8_t in_AUdur = 6;
const uint8_t in_AUdoux = 7;

// Les étapes, dans l'ordre des tables.
enum { X0, X1, X2, STEPS, STEP_WORDS = STEPS / 32 + 1 };

typedef struct {
    bool m;
    bool a;
    bool b;
    bool Init;  // 1 : situation initiale
    bool AUdur;  // 1 : aucune étape active
    bool AUdoux;  // 1 : actions continues à 0, étapes conservées
} single_sequence_inputs;

typedef struct {
    bool none;
} single_sequence_outputs;

// Tout ce qu'une scrutation transmet à la suivante.
typedef struct {
    single_sequence_inputs inputs;
    single_sequence_outputs outputs;
    int64_t now;  // instant de la scrutation, en us
    // Tables des étapes, un bit par étape.
    uint32_t Ts[STEP_WORDS];  // situation
    uint32_t Tp[STEP_WORDS];  // situation en début de scrutation
    uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];  // à activer, à désactiver
    // Réceptivités des transitions.
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

// SBR 1 : situation en début de scrutation ; tables de travail à 0
static void begin_scan(single_sequence_grafcet *g) {
    for (int w = 0; w < STEP_WORDS; ++w) g->Tp[w] = g->Ts[w];
    for (int w = 0; w < STEP_WORDS; ++w) g->Ta[w] = g->Td[w] = 0;
}

// SBR 3 : réceptivités
static void test_conditions(single_sequence_grafcet *g) {
    // (0) 0 -> 1 : m
    g->Tt.t_0 = g->inputs.m;
    // (1) 1 -> 2 : a
    g->Tt.t_1 = g->inputs.a;
    // (2) 2 -> 0 : b
    g->Tt.t_2 = g->inputs.b;
}

// SBR 4 : évolution, règles 2 à 5
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
    // Init : étapes initiales
    if (g->inputs.Init) {
        set(g->Ts, X0);
    }
    // Init : toutes les autres étapes
    if (g->inputs.Init) {
        reset_all(g->Ts, X1, X2);
    }
}

// SBR 5 : forçages et encapsulations
static void obey_orders(single_sequence_grafcet *g) {
    // AUdur : toutes les étapes
    if (g->inputs.AUdur) {
        reset_all(g->Ts, X0, X2);
    }
}

// SBR 0 : avant la première scrutation, situation initiale
void single_sequence_start(single_sequence_grafcet *g, const single_sequence_inputs *in) {
    memset(g, 0, sizeof *g);
    g->inputs = *in;
    // étape initiale 0
    set(g->Ts, X0);
    set(g->Tp, X0);
}

// Une scrutation. L'horloge, en us, ne recule jamais.
void single_sequence_scan(single_sequence_grafcet *g, const single_sequence_inputs *in, int64_t
        now) {
    g->inputs = *in;
    g->now = now;
    begin_scan(g);
    test_conditions(g);
    evolve(g);
    obey_orders(g);
}

// micros() repart de 0 après 71 minutes ; cette horloge non, si elle est lue plus souvent.
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
    // Le temps que les résistances de tirage chargent les fils.
    delay(1);
    read_inputs();
    single_sequence_start(&chart, &inputs);
}

// Une scrutation.
void loop() {
    read_inputs();
    single_sequence_scan(&chart, &inputs, clock_now());
    write_outputs();
}
