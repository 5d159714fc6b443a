// The exploration asks many times a second whether to go on, so the clock is the only thing looked
// at each time; memory and terminal take longer and are looked at now and then. Ctrl-C only sets a
// flag: the check ends as it does at any other bound, with a report of what it has found.

#include "command/progress.h"

#include <unistd.h>

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

namespace {

/// Set by Ctrl-C. The handler is removed as it is called, so that a second one ends the program.
volatile std::sig_atomic_t is_interrupted = 0;

void note_interrupt(int) {
    is_interrupted = 1;
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

Progress::Progress(double max_seconds, std::uint64_t max_memory, Language language)
    : language_(language),
      max_seconds_(max_seconds),
      max_memory_(max_memory),
      is_terminal_(isatty(STDERR_FILENO) == 1) {
    is_interrupted = 0;
    struct sigaction once {};
    once.sa_handler = note_interrupt;
    once.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &once, nullptr);
}

Progress::~Progress() {
    std::signal(SIGINT, SIG_DFL);
    if (shown_) show_raw("\r\033[K");
}

double Progress::elapsed() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
}

bool Progress::goes_on() {
    const double now = elapsed();
    if (is_interrupted != 0 || (max_seconds_ != 0 && now >= max_seconds_)) is_over_ = true;
    if (max_memory_ != 0) {
        const std::lock_guard lock(mutex_);
        if (now >= next_look_at_memory_) {
            if (memory_held() >= max_memory_) is_over_ = true;
            next_look_at_memory_ = now + 0.05;
        }
    }
    return !is_over_;
}

void Progress::show(const Coverage& coverage) {
    const double now = elapsed();
    if (!is_terminal_ || now <= next_) return;
    show_raw("\r\033[K" +
             messages::command::progress.in(language_, counted::cases(coverage.cases),
                                            counted::situations(coverage.situations),
                                            counted::waiting_states(coverage.waiting)));
    shown_ = true;
    next_ = now + 0.5;
}

std::optional<std::uint64_t> parse_memory(const std::string& text) {
    std::uint64_t amount = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
    const std::string unit(end, text.data() + text.size());
    const int shift = unit == "k" ? 10 : unit == "M" || unit.empty() ? 20 : unit == "G" ? 30 : 0;
    if (error != std::errc() || shift == 0 || amount == 0 || amount > (UINT64_MAX >> shift)) {
        complain(messages::command::no_amount_of_memory(visible(text)));
        return std::nullopt;
    }
    return amount << shift;
}

}  // namespace grafwire
