#pragma once

#include <cstddef>
#include <functional>

#include "text/workers.h"

namespace grafwire::testing {

/// Three workers who do everything in an order that nobody would expect: the last item first.
class BackwardWorkers : public Workers {
  public:
    std::size_t count() const override { return 3; }
    void share(std::size_t items,
               const std::function<void(std::size_t item, std::size_t worker)>& work,
               const std::function<void()>& meanwhile) override {
        for (std::size_t item = items; item-- > 0;) {
            work(item, item * 7 % count());
            meanwhile();
        }
    }
};

}  // namespace grafwire::testing
