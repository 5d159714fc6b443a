#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace grafwire {

/// Values on their way from one worker to another, in order. One pushes and one pops, each as it
/// likes; neither waits for the other. A list: the one who pushes holds its last link, the one who
/// pops its first, which is empty.
template <class Value>
class HandOver {
  public:
    HandOver() : first_(new Link()), last_(first_) {}
    ~HandOver() {
        while (first_ != nullptr) delete std::exchange(first_, first_->next.load());
    }
    HandOver(const HandOver&) = delete;
    HandOver& operator=(const HandOver&) = delete;

    void push(Value value) {
        auto link = std::make_unique<Link>();
        link->value = std::move(value);
        Link* added = link.release();
        last_->next.store(added);
        last_ = added;
    }

    /// The first value that has not been popped; nothing where none is there yet.
    std::optional<Value> pop() {
        Link* next = first_->next.load();
        if (next == nullptr) return std::nullopt;
        delete std::exchange(first_, next);
        return std::exchange(first_->value, std::nullopt);
    }

  private:
    struct Link {
        std::optional<Value> value;
        std::atomic<Link*> next = nullptr;
    };
    Link* first_;
    Link* last_;
};

}  // namespace grafwire
