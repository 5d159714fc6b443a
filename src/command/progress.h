#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "check/check_result.h"
#include "text/message.h"

namespace grafwire {

/// Shows how far the exploration is, on a terminal, once it takes more than a moment; and ends it
/// when its time or its memory is used up, or when the user wants it to end (Ctrl-C, once; the
/// second time ends the program).
class Progress {
  public:
    /// `max_memory` in bytes; 0 stands for no bound, likewise for the seconds.
    Progress(double max_seconds, std::uint64_t max_memory, Language language);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(const Coverage& coverage);
    /// Many may ask at the same time.
    bool goes_on();

  private:
    using Clock = std::chrono::steady_clock;
    double elapsed() const;

    Language language_;
    Clock::time_point begin_ = Clock::now();
    double max_seconds_;
    std::uint64_t max_memory_;
    double next_ = 1.0;
    double next_look_at_memory_ = 0;
    std::atomic<bool> is_over_ = false;
    std::mutex mutex_;  ///< of next_look_at_memory_
    bool is_terminal_;
    bool shown_ = false;
};

/// `500M`, `2G`, a number of MiB without a unit; in bytes. Empty (and shown) if it is none.
std::optional<std::uint64_t> parse_memory(const std::string& text);

}  // namespace grafwire
