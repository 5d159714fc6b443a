// single_sequence : Séquence unique
// Écrit par grafwire 0.2.0 avec : grafwire plc single-sequence.grafcet --to c --modes on --lang fr
//
// GRAFCET (CEI 60848), programme en C99. Une scrutation est
// celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;
// chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8.
//
// Inclure ce fichier là où la scrutation est appelée :
//   single_sequence_inputs in;      y mettre les entrées
//   single_sequence_grafcet g;
//   single_sequence_start(&g, &in);       une fois
//   single_sequence_scan(&g, &in, now);   en boucle ; now : une horloge en us
//   g.outputs               sont les sorties
// Pour l'essayer sur les scrutations d'une trace de la référence :
//   cc -std=c99 -DGRAFWIRE_MAIN CE_FICHIER -o programme
//   grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv
//   ./programme < trace.csv | diff - trace.csv

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

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

// Lit une ligne par scrutation : l'instant en ms, les entrées à 0 ou 1. La première ligne et
// les colonnes en plus sont ignorées. Écrit la trace dans les colonnes de la référence.
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
            fprintf(stderr, "ligne %ld : instant en ms attendu (entier en us), puis %d entrées\n",
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
