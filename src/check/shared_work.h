#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <utility>

#include "check/hand_over.h"
#include "text/workers.h"

namespace grafwire {

/// What is done with items by those who share them.
template <class Item, class Found>
struct SharedSteps {
    /// Asked when it is an item's turn: whether it is left out, for all that is known by then.
    std::function<bool(const Item&)> is_left_out;
    /// Hands over what an item comes to, in an order that depends on it alone, until the function
    /// says no; false where it was broken off before. The worker is one of several at the same
    /// time, so nothing may be used that changes.
    std::function<bool(const Item&, std::size_t worker, const std::function<bool(Found&&)>&)> find;
    /// Takes one thing that was found.
    std::function<void(const Item&, Found&)> take;
};

/// Items that several work on side by side, while one of them takes what is found in the order of
/// the items, one thing at a time: so everything comes as it comes to a worker alone. And as soon
/// as it can be, since it may end the whole. Only the caller of the workers takes, so that all that
/// is known is his.
template <class Item, class Found>
class SharedWork {
  public:
    /// `workers`: nullptr for one alone.
    explicit SharedWork(Workers* workers) : workers_(workers) {}

    std::size_t count() const { return workers_ == nullptr ? 1 : workers_->count(); }
    /// Whether all has been ended. Every worker may ask, and end it.
    bool is_over() const { return is_over_; }
    void end() { is_over_ = true; }

    /// Does all the items, which are gone then.
    void run(std::deque<Item>& items, const SharedSteps<Item, Found>& steps) {
        steps_ = &steps;
        for (Item& item : items) tasks_.emplace_back(std::move(item));
        items.clear();
        const auto work = [this](std::size_t item, std::size_t worker) {
            find(tasks_[item], worker);
        };
        workers_->share(tasks_.size(), work, [this] { take_turns(); });
        take_turns();
        tasks_.clear();
        turn_ = 0;
    }

    /// Takes what has been found by now of the items whose turn it is. For the caller's own work on
    /// an item, which may be long.
    void take_turns() {
        for (; turn_ < tasks_.size() && !is_over_; ++turn_) {
            Task& task = tasks_[turn_];
            const bool is_done = task.is_done;  // asked first: then all that is found is there
            if (!task.has_begun) task.is_left_out = steps_->is_left_out(task.item);
            task.has_begun = true;
            while (auto found = task.found.pop()) {
                if (!task.is_left_out) steps_->take(task.item, *found);
                if (is_over_) return;
            }
            if (!is_done) return;
            if (!task.is_whole) end();
        }
    }

  private:
    /// An item that is worked on while those before it may not have had their turn.
    struct Task {
        explicit Task(Item&& it) : item(std::move(it)) {}
        Item item;
        HandOver<Found> found;
        bool is_whole = true;               ///< or it was broken off after these
        std::atomic<bool> is_done = false;  ///< no more comes
        bool has_begun = false;             ///< its turn has come
        bool is_left_out = false;
    };

    /// Sees to it that an exception of one worker ends the others as well.
    struct EndsOthers {
        const Task& task;
        SharedWork& all;
        ~EndsOthers() {
            if (!task.is_done) all.end();
        }
    };

    void find(Task& task, std::size_t worker) {
        const EndsOthers ends_others{task, *this};
        const bool is_caller = worker == 0;
        const auto hand_over = [&](Found&& found) {
            task.found.push(std::move(found));
            if (is_caller) take_turns();
            return !is_over_;
        };
        if (!is_over_) task.is_whole = steps_->find(task.item, worker, hand_over);
        task.is_done = true;
        if (is_caller) take_turns();
    }

    Workers* workers_;
    const SharedSteps<Item, Found>* steps_ = nullptr;
    std::deque<Task> tasks_;  ///< in the order of the items
    std::size_t turn_ = 0;    ///< of tasks_: whose turn it is
    std::atomic<bool> is_over_ = false;
};

}  // namespace grafwire
