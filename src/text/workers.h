#pragma once

#include <cstddef>
#include <functional>

namespace grafwire {

/// Those who share long work: the cores of a machine, as far as the caller has them. What is below
/// the command line knows no threads; it says what can be done side by side.
class Workers {
  public:
    virtual ~Workers() = default;

    /// How many there are, at least 1.
    virtual std::size_t count() const = 0;
    /// Calls `work(item, worker)` once for every item below `items`, the first ones first where
    /// that can be, and several at a time; each worker, numbered below count(), has one item at a
    /// time, and the caller is worker 0. While it waits for the others it calls `meanwhile` again
    /// and again. Returns when all are done. What `work` throws is thrown on then.
    virtual void share(std::size_t items,
                       const std::function<void(std::size_t item, std::size_t worker)>& work,
                       const std::function<void()>& meanwhile) = 0;
};

}  // namespace grafwire
