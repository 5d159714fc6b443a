// Threads that share work item by item: each takes the next one as soon as it has none, so that one
// long item keeps nobody else waiting. An item is long beside a lock (it takes microseconds at
// least), so one mutex for all is enough.

#include "command/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace grafwire {

namespace {

constexpr std::size_t most_workers = 256;
constexpr std::chrono::milliseconds between_looks(2);

}  // namespace

WorkerPool::WorkerPool(std::size_t count) {
    if (count == 0) count = std::thread::hardware_concurrency();
    count = std::min(count, most_workers);
    threads_.reserve(count);
    try {
        for (std::size_t worker = 1; worker < count; ++worker) {
            threads_.emplace_back([this, worker] { serve(worker); });
        }
    } catch (const std::exception&) {
        // The system has no more threads to give, or no memory for them; those there are do the
        // work.
    }
}

WorkerPool::~WorkerPool() {
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    work_came_.notify_all();
    for (std::thread& thread : threads_) thread.join();
}

/// Does something with the mutex free. What it throws is kept, and what nobody has begun is left.
void WorkerPool::attempt(std::unique_lock<std::mutex>& lock, const std::function<void()>& what) {
    lock.unlock();
    std::exception_ptr failure;
    try {
        what();
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (failure == nullptr) return;
    if (failure_ == nullptr) failure_ = failure;
    next_ = items_;
}

/// Takes items until there are none left, and leaves the mutex held.
void WorkerPool::take_items(std::unique_lock<std::mutex>& lock, std::size_t worker) {
    while (next_ < items_) {
        const std::size_t item = next_++;
        ++busy_;
        attempt(lock, [&] { (*work_)(item, worker); });
        --busy_;
    }
    if (busy_ == 0) work_ended_.notify_all();
}

void WorkerPool::serve(std::size_t worker) {
    std::unique_lock lock(mutex_);
    while (!is_over_) {
        take_items(lock, worker);
        work_came_.wait(lock, [this] { return is_over_ || next_ < items_; });
    }
}

void WorkerPool::share(std::size_t items,
                       const std::function<void(std::size_t item, std::size_t worker)>& work,
                       const std::function<void()>& meanwhile) {
    std::unique_lock lock(mutex_);
    work_ = &work;
    next_ = 0;
    items_ = items;
    work_came_.notify_all();
    take_items(lock, 0);
    while (!work_ended_.wait_for(lock, between_looks, [this] { return busy_ == 0; })) {
        attempt(lock, meanwhile);
    }
    items_ = 0;
    if (failure_ != nullptr) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace grafwire
