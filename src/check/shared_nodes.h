#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <utility>

#include "check/hand_over.h"
#include "text/workers.h"

namespace grafwire {

/// What an exploration does with a node of its own.
template <class Node, class Found>
struct NodeSteps {
    /// Whether a node need not be expanded, for all that is known by now.
    std::function<bool(const Node&)> is_covered;
    /// Gives all that leaves a node, in an order that depends on the node alone, until the function
    /// says no; false where it was broken off before. The worker is one of several at the same
    /// time, so nothing may be used that changes.
    std::function<bool(const Node&, std::size_t worker, const std::function<bool(Found&&)>&)>
        expand;
    /// Takes one thing that leaves a node.
    std::function<void(const Node&, Found&)> take;
};

/// Expands nodes side by side, and takes what leaves them in their order, one at a time: so
/// everything comes as it comes to a worker alone. And as soon as it can be, since it may end the
/// exploration. Only the caller of the workers takes, so that all that is known of nodes is his.
template <class Node, class Found>
class SharedNodes {
  public:
    /// `workers`: nullptr for one alone.
    explicit SharedNodes(Workers* workers) : workers_(workers) {}

    std::size_t count() const { return workers_ == nullptr ? 1 : workers_->count(); }
    /// Whether the exploration has been ended. Every worker may ask, and end it.
    bool is_over() const { return is_over_; }
    void end() { is_over_ = true; }
    /// The nodes that were taken from those waiting and have not had their turn.
    std::size_t ahead() const { return ahead_; }

    /// Expands some of the nodes that wait longest, and takes what leaves them.
    void expand(std::deque<Node>& waiting, const NodeSteps<Node, Found>& steps) {
        steps_ = &steps;
        const std::size_t some = std::min(waiting.size(), nodes_of_a_worker * count());
        for (std::size_t i = 0; i < some; ++i) {
            Task& task = tasks_.emplace_back();
            task.node = std::move(waiting.front());
            task.is_left_out = steps.is_covered(task.node);
            waiting.pop_front();
        }
        workers_->share(
            some,
            [this](std::size_t item, std::size_t worker) { expand_one(tasks_[item], worker); },
            [this] { take_turns(); });
        take_turns();
        tasks_.clear();
        turn_ = 0;
    }

    /// Takes from the nodes whose turn it is what is there by now. For the caller's own work within
    /// a node, which may be long.
    void take_turns() {
        for (; turn_ < tasks_.size() && !is_over_; ++turn_) {
            Task& task = tasks_[turn_];
            const bool is_done = task.is_done;  // asked first: then all that leaves it is there
            ahead_ = tasks_.size() - turn_ - 1;
            if (!task.has_begun) task.is_covered = steps_->is_covered(task.node);
            task.has_begun = true;
            while (auto found = task.found.pop()) {
                if (!task.is_covered) steps_->take(task.node, *found);
                if (is_over_) return;
            }
            if (!is_done) return;
            if (!task.is_whole) end();
        }
    }

  private:
    /// So many nodes a worker has before it at a time.
    static constexpr std::size_t nodes_of_a_worker = 32;

    /// A node that is expanded while those before it may not have had their turn.
    struct Task {
        Node node;
        bool is_left_out = false;  ///< it was covered before
        HandOver<Found> found;
        bool is_whole = true;               ///< or it was broken off after these
        std::atomic<bool> is_done = false;  ///< no more comes
        bool has_begun = false;             ///< its turn has come
        bool is_covered = false;            ///< by then
    };

    /// Sees to it that an exception of one worker ends the others as well.
    struct EndsOthers {
        const Task& task;
        SharedNodes& all;
        ~EndsOthers() {
            if (!task.is_done) all.end();
        }
    };

    void expand_one(Task& task, std::size_t worker) {
        const EndsOthers ends_others{task, *this};
        const bool is_caller = worker == 0;
        const auto hand_over = [&](Found&& found) {
            task.found.push(std::move(found));
            if (is_caller) take_turns();
            return !is_over_;
        };
        if (!task.is_left_out && !is_over_) {
            task.is_whole = steps_->expand(task.node, worker, hand_over);
        }
        task.is_done = true;
        if (is_caller) take_turns();
    }

    Workers* workers_;
    const NodeSteps<Node, Found>* steps_ = nullptr;
    std::deque<Task> tasks_;  ///< nodes that are being expanded, in their order
    std::size_t turn_ = 0;    ///< of tasks_: whose turn it is
    std::size_t ahead_ = 0;   ///< of tasks_: those after it
    std::atomic<bool> is_over_ = false;
};

}  // namespace grafwire
