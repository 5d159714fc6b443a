#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/check_progress.h"

namespace grafwire::playground {

class Runs;

/// Answers the requests of the page. It keeps the runs that are under way, and nothing else.
class Core {
  public:
    Core();
    ~Core();
    Core(const Core&) = delete;
    Core& operator=(const Core&) = delete;

    /// `{"name":"chart","args":{"text":"…"}}` to an answer, an object in JSON: what was asked for,
    /// or `error`, why there is no answer. Whatever the request is, the core lives on.
    std::string call(std::string_view request, const CheckProgress& progress = {});

  private:
    std::unique_ptr<Runs> runs_;
};

}  // namespace grafwire::playground
