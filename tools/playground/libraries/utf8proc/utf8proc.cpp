#include "utf8proc.h"

#include <cstdlib>

/// Of the page: writes the text in normal form C to a place that it gets from playground_allocate
/// and puts into `result`; its size, or -1.
extern "C" __attribute__((import_module("page"), import_name("normalise"))) std::int32_t normalise(
    const std::uint8_t* text, std::int32_t size, std::uint8_t** result);

utf8proc_ssize_t utf8proc_map(const utf8proc_uint8_t* text, utf8proc_ssize_t size,
                              utf8proc_uint8_t** result, utf8proc_option_t) {
    return normalise(text, size, result);
}
