#pragma once

#include <string_view>

namespace grafwire::c {

// The parts of a program in C that are the same for every chart. An @ stands for a text in the
// language of the reader (with_texts).

inline constexpr std::string_view time_type = R"(
// @time_condition
typedef struct {
    bool value;
    bool waits;     // @e_differs
    int64_t since;  // @differs_since
} time_condition;
)";

/// A function that is written only where another one calls it; INTEGER stands for the type.
struct Helper {
    std::string_view name;
    std::string_view text;
};

/// Those that call others come before them.
inline constexpr Helper helpers[] = {
    {"set_all", R"(
static inline void set_all(uint32_t *table, int first, int last) {
    for (int step = first; step <= last; ++step) set(table, step);
}
)"},
    {"reset_all", R"(
static inline void reset_all(uint32_t *table, int first, int last) {
    for (int step = first; step <= last; ++step) reset(table, step);
}
)"},
    {"is", R"(
static inline bool is(const uint32_t *table, int step) {
    return ((table[step / 32] >> (step % 32)) & 1u) != 0;
}
)"},
    {"set", R"(
static inline void set(uint32_t *table, int step) {
    table[step / 32] |= (uint32_t)1 << (step % 32);
}
)"},
    {"reset", R"(
static inline void reset(uint32_t *table, int step) {
    table[step / 32] &= ~((uint32_t)1 << (step % 32));
}
)"},
    {"within", R"(
static inline INTEGER within(INTEGER low, INTEGER value, INTEGER high) {
    return value < low ? low : value > high ? high : value;
}
)"},
    {"observe", R"(
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
)"},
};

inline constexpr std::string_view main_head = R"(
#ifdef GRAFWIRE_MAIN

#include <stdio.h>

// @reads_moment
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

// @input_columns
)";

inline constexpr std::string_view read_scan = R"(
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
)";

}  // namespace grafwire::c
