// The exploration asks many times a second whether to go on, so the clock is the only thing looked
// at each time; memory and terminal take longer and are looked at now and then. Ctrl-C only sets a
// flag: the check ends as it does at any other bound, with a report of what it has found.

#include "command/progress.h"

#include <unistd.h>

#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "command/messages.h"
#include "command/standard_error.h"
#include "text/counted.h"
#include "text/utf8.h"

namespace grafwire {

namespace counted = messages::counted;
namespace say = messages::command;

namespace {

/// Set by Ctrl-C, and looked at by all checks that are running. The handler is removed as it is
/// called, so that a second one ends the program.
std::atomic<bool> is_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler of signals sets it");

void note_interrupt(int) {
    is_interrupted = true;
}

/// What the program holds in memory, in bytes; 0 where the system does not tell.
std::uint64_t memory_held() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t whole = 0;
    std::uint64_t held = 0;
    file >> whole >> held;
    return held * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Interruption::Interruption() {
    is_interrupted = false;
    struct sigaction once {};
    once.sa_handler = note_interrupt;
    once.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &once, nullptr);
}

Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
}

bool Interruption::is_asked_for() {
    return is_interrupted;
}

ProgressLine::ProgressLine(Language language, std::size_t checks)
    : language_(language), checks_(checks), is_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (shown_) show_raw("\r\033[K");
}

void ProgressLine::show(const Coverage& coverage, const std::string& name) {
    if (!is_terminal_) return;
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (now <= next_) return;
    const std::string far = say::progress.in(language_, counted::cases(coverage.cases),
                                             counted::situations(coverage.situations),
                                             counted::waiting_states(coverage.waiting));
    show_raw("\r\033[K" + (checks_ == 1 ? far
                                        : say::progress_of_several.in(language_, done_, checks_,
                                                                      shortened(name, 30), far)));
    shown_ = true;
    next_ = now + std::chrono::milliseconds(500);
}

void ProgressLine::count_done() {
    const std::lock_guard lock(mutex_);
    ++done_;
}

CheckBounds::CheckBounds(double max_seconds, std::uint64_t max_memory)
    : max_seconds_(max_seconds), max_memory_(max_memory) {}

bool CheckBounds::goes_on() {
    const double now = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (Interruption::is_asked_for() || (max_seconds_ != 0 && now >= max_seconds_)) is_over_ = true;
    if (max_memory_ != 0) {
        const std::lock_guard lock(mutex_);
        if (now >= next_look_at_memory_) {
            if (memory_held() >= max_memory_) is_over_ = true;
            next_look_at_memory_ = now + 0.05;
        }
    }
    return !is_over_;
}

std::optional<std::uint64_t> parse_memory(const std::string& text) {
    std::uint64_t amount = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
    const std::string unit(end, text.data() + text.size());
    const int shift = unit == "k" ? 10 : unit == "M" || unit.empty() ? 20 : unit == "G" ? 30 : 0;
    if (error != std::errc() || shift == 0 || amount == 0 || amount > (UINT64_MAX >> shift)) {
        complain(say::no_amount_of_memory(visible(text)));
        return std::nullopt;
    }
    return amount << shift;
}

}  // namespace grafwire
