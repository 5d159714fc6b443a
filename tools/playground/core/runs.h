#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "workflow/live_run.h"

namespace grafwire::playground {

/// The runs that are open, by the numbers that the page knows them by.
class Runs {
  public:
    struct OpenRun {
        std::uint32_t number = 0;
        Language language = Language::english;
        std::unique_ptr<LiveRun> run;
    };
    OpenRun& open(std::unique_ptr<LiveRun> run, Language language);
    /// nullptr where there is none.
    OpenRun* find(double number);
    void close(std::uint32_t number) { runs_.erase(number); }

  private:
    std::map<std::uint32_t, OpenRun> runs_;
    std::uint32_t last_ = 0;
};

}  // namespace grafwire::playground
