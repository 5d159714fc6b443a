// What core.js calls, and what it offers.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/call.h"

namespace {

/// Of the page: shown how far a check is; 0 ends it.
extern "C" __attribute__((import_module("page"), import_name("progress"))) std::int32_t progress(
    double situations, double cases, double unstable, double waiting);

/// The answer that playground_call has given last.
std::string& answer() {
    static std::string text;
    return text;
}

}  // namespace

/// Room for a text of the page; playground_free gives it back.
extern "C" __attribute__((export_name("playground_allocate"))) void* playground_allocate(
    std::size_t size) {
    return std::malloc(size);
}
extern "C" __attribute__((export_name("playground_free"))) void playground_free(void* room) {
    std::free(room);
}

/// The size of the answer to a request; playground_answer is where it stands until the next call.
extern "C" __attribute__((export_name("playground_call"))) std::size_t playground_call(
    const char* request, std::size_t size) {
    static grafwire::playground::Core core;
    answer() = core.call({request, size}, [](const grafwire::Coverage& coverage) {
        return progress(static_cast<double>(coverage.situations),
                        static_cast<double>(coverage.cases), static_cast<double>(coverage.unstable),
                        static_cast<double>(coverage.waiting)) != 0;
    });
    return answer().size();
}
extern "C" __attribute__((export_name("playground_answer"))) const char* playground_answer() {
    return answer().data();
}
