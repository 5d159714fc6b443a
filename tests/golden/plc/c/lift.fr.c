// lift : Monte-charge
// Écrit par grafwire 0.2.0 avec : grafwire plc lift.grafcet --to c --modes on --lang fr
//
// GRAFCET (CEI 60848), programme en C99. Une scrutation est
// celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
// chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.
//
// Inclure ce fichier là où la scrutation est appelée :
//   lift_inputs in;      y mettre les entrées
//   lift_grafcet g;
//   lift_start(&g, &in);       une fois
//   lift_scan(&g, &in, now);   en boucle ; now : une horloge en us
//   g.outputs               sont les sorties
// Pour l'essayer sur les scrutations d'une trace de la référence :
//   cc -std=c99 -DGRAFWIRE_MAIN CE_FICHIER -o programme
//   grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv
//   ./programme < trace.csv | diff - trace.csv
//
// Noms écrits autrement dans le GRAFCET :
//   arret  arrêt
//   int_2  int

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

// Les étapes, dans l'ordre des tables.
enum { X0, X1, X2, X10, X11, X12, STEPS, STEP_WORDS = STEPS / 32 + 1 };

// Temporisation t1/e/t2 : 1 quand e vaut 1 depuis t1, 0 quand e vaut 0 depuis t2.
typedef struct {
    bool value;
    bool waits;     // e diffère de la valeur
    int64_t since;  // pendant l'attente : l'instant depuis lequel e diffère, en us
} time_condition;

typedef struct {
    bool crate;
    bool top;
    bool arret;
    bool int_2;
    bool Init;  // 1 : situation initiale
    bool AUdur;  // 1 : aucune étape active
    bool AUdoux;  // 1 : actions continues à 0, étapes conservées
} lift_inputs;

typedef struct {
    bool UP;
    bool blow;
    bool lamp;
} lift_outputs;

// Tout ce qu'une scrutation transmet à la suivante.
typedef struct {
    lift_inputs inputs;
    lift_outputs outputs;
    int64_t now;  // instant de la scrutation, en us
    // Tables des étapes, un bit par étape.
    uint32_t Ts[STEP_WORDS];  // situation
    uint32_t Tp[STEP_WORDS];  // situation en début de scrutation
    uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];  // à activer, à désactiver
    uint32_t Tf1[STEP_WORDS], Tf0[STEP_WORDS];  // forcées à 1, forcées à 0
    uint32_t Tpulse[STEP_WORDS];  // activées dans cette scrutation
    // Réceptivités des transitions.
    struct { bool t0, t1, t2, t_go, t4, t5; } Tt;
    // Fronts, à 1 dans la scrutation où ils se produisent.
    struct { bool rise_top, rise_crate; } edge;
    // Valeurs des opérandes des fronts à la scrutation précédente.
    struct { bool rise_top, rise_crate; } memory;
    // Temporisations.
    struct { time_condition t1_5s_top_20ms; } time;
    // Variables internes.
    struct { bool full; } vars;
    // Compteurs.
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

// SBR 1 : situation en début de scrutation ; tables de travail à 0
static void begin_scan(lift_grafcet *g) {
    for (int w = 0; w < STEP_WORDS; ++w) g->Tp[w] = g->Ts[w];
    for (int w = 0; w < STEP_WORDS; ++w) g->Ta[w] = g->Td[w] = g->Tf1[w] = g->Tf0[w] = 0;
}

// SBR 2 : fronts
static void find_edges(lift_grafcet *g) {
    // ↑top
    g->edge.rise_top = g->inputs.top && !g->memory.rise_top;
    // mémoire de ↑top
    g->memory.rise_top = g->inputs.top;
    // ↑crate
    g->edge.rise_crate = g->inputs.crate && !g->memory.rise_crate;
    // mémoire de ↑crate
    g->memory.rise_crate = g->inputs.crate;
}

// SBR 3 : réceptivités
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

// SBR 4 : évolution, règles 2 à 5
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
    // Init : étapes initiales
    if (g->inputs.Init) {
        set(g->Ts, X0);
        set(g->Ts, X10);
    }
    // Init : toutes les autres étapes
    if (g->inputs.Init) {
        reset_all(g->Ts, X1, X2);
        reset_all(g->Ts, X11, X12);
    }
}

// SBR 5 : forçages et encapsulations
static void obey_orders(lift_grafcet *g) {
    // ordres de forçage de l'étape 1
    if (is(g->Ts, X1)) {
        set_all(g->Tf0, X10, X12);
    }
    // ordres de forçage de l'étape 2
    if (is(g->Ts, X2)) {
        set(g->Tf1, X10);
        set_all(g->Tf0, X10, X12);
    }
    // Ts = Ts . /Tf0 + Tf1
    for (int w = 0; w < STEP_WORDS; ++w) g->Ts[w] = (g->Ts[w] & ~g->Tf0[w]) | g->Tf1[w];
    // AUdur : toutes les étapes
    if (g->inputs.AUdur) {
        reset_all(g->Ts, X0, X12);
    }
    // Tpulse = Ts . /Tp
    for (int w = 0; w < STEP_WORDS; ++w) g->Tpulse[w] = g->Ts[w] & ~g->Tp[w];
}

// SBR 5, fin : actions mémorisées
static void run_stored_actions(lift_grafcet *g) {
    // full au franchissement de (5) 12 -> 10
    if (is(g->Tp, X12) && g->Tt.t5 && !g->inputs.Init) {
        g->vars.full = false;
    }
    // n à l'activation de l'étape 11
    if (is(g->Tpulse, X11)) {
        g->counters.n = within(0, g->counters.n + 1, 3);
    }
    // full sur événement à l'étape 12
    if (is(g->Ts, X12) && g->edge.rise_top) {
        g->vars.full = true;
    }
}

// SBR 6 : temporisations
static void observe_times(lift_grafcet *g) {
    // 1.5s/top/20ms
    observe(&g->time.t1_5s_top_20ms, g->inputs.top, 1500000, 20000, g->now);
}

// SBR 8 : sorties
static void drive_outputs(lift_grafcet *g) {
    // UP
    g->outputs.UP = is(g->Ts, X11) && !g->inputs.top && !g->inputs.AUdoux;
    // blow
    g->outputs.blow = is(g->Ts, X12) && !g->inputs.AUdoux;
    // lamp
    g->outputs.lamp = is(g->Ts, X1) && !g->inputs.AUdoux;
}

// SBR 0 : avant la première scrutation, situation initiale
void lift_start(lift_grafcet *g, const lift_inputs *in) {
    memset(g, 0, sizeof *g);
    g->inputs = *in;
    // étape initiale 0
    set(g->Ts, X0);
    set(g->Tp, X0);
    // étape initiale 10
    set(g->Ts, X10);
    set(g->Tp, X10);
    // n
    g->counters.n = 0;
    // mémoire de ↑top
    g->memory.rise_top = g->inputs.top;
    // mémoire de ↑crate
    g->memory.rise_crate = g->inputs.crate;
}

// Une scrutation. L'horloge, en us, ne recule jamais.
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

// Lit un instant en ms, comme `0.5`, et le donne en us. Vrai si c'en est un, entier en us.
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

// Les colonnes des entrées ; Init, AUdur et AUdoux y sont toujours.
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

// Lit une ligne par scrutation : l'instant en ms, les entrées à 0 ou 1. La première ligne et
// les colonnes en plus sont ignorées. Écrit la trace dans les colonnes de la référence.
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
            fprintf(stderr, "ligne %ld : instant en ms attendu (entier en us), puis %d entrées\n",
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
