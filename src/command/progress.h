#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "check/check_result.h"
#include "text/message.h"

namespace grafwire {

/// While it lives Ctrl-C ends no program but the checks that are running, and those that come; the
/// second time it ends the program. One at a time.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool is_asked_for();
};

/// A line on the terminal that says how far checks are, once they take more than a moment. Checks
/// that run at the same time take turns in it.
class ProgressLine {
  public:
    /// `checks`: how many there are.
    explicit ProgressLine(Language language, std::size_t checks = 1);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// `name`: of the check, where there are several.
    void show(const Coverage& coverage, const std::string& name);
    /// One check more is done.
    void count_done();

  private:
    using Clock = std::chrono::steady_clock;

    Language language_;
    std::size_t checks_;
    bool is_terminal_;
    std::mutex mutex_;  ///< of what follows
    std::size_t done_ = 0;
    Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
    bool shown_ = false;
};

/// When a check is to end: its time or the memory of the program is used up, or Ctrl-C.
class CheckBounds {
  public:
    /// `max_memory` in bytes; 0 stands for no bound, likewise for the seconds.
    CheckBounds(double max_seconds, std::uint64_t max_memory);
    /// Many may ask at the same time.
    bool goes_on();

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point begin_ = Clock::now();
    double max_seconds_;
    std::uint64_t max_memory_;
    std::atomic<bool> is_over_ = false;
    std::mutex mutex_;  ///< of next_look_at_memory_
    double next_look_at_memory_ = 0;
};

/// All of these for a single check, or for several that share their bounds.
class Progress {
  public:
    Progress(double max_seconds, std::uint64_t max_memory, Language language)
        : line_(language), bounds_(max_seconds, max_memory) {}

    void show(const Coverage& coverage) { line_.show(coverage, {}); }
    bool goes_on() { return bounds_.goes_on(); }

  private:
    Interruption interruption_;
    ProgressLine line_;
    CheckBounds bounds_;
};

/// `500M`, `2G`, a number of MiB without a unit; in bytes. Empty (and shown) if it is none.
std::optional<std::uint64_t> parse_memory(const std::string& text);

}  // namespace grafwire
