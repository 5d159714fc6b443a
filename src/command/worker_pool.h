#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "text/workers.h"

namespace grafwire {

/// Threads that share work; the one that asks for it is the first of them.
class WorkerPool : public Workers {
  public:
    /// `count`: how many, itself included; 0: as many as the machine has cores. Fewer where the
    /// system does not give so many, or nobody could want them.
    explicit WorkerPool(std::size_t count);
    ~WorkerPool() override;
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    std::size_t count() const override { return threads_.size() + 1; }
    void share(std::size_t items,
               const std::function<void(std::size_t item, std::size_t worker)>& work,
               const std::function<void()>& meanwhile) override;

  private:
    void attempt(std::unique_lock<std::mutex>& lock, const std::function<void()>& what);
    void serve(std::size_t worker);
    void take_items(std::unique_lock<std::mutex>& lock, std::size_t worker);

    std::mutex mutex_;
    std::condition_variable work_came_;
    std::condition_variable work_ended_;
    const std::function<void(std::size_t, std::size_t)>* work_ = nullptr;
    std::size_t next_ = 0;   ///< the first item that nobody has
    std::size_t items_ = 0;  ///< of the present work
    std::size_t busy_ = 0;   ///< workers that have an item
    std::exception_ptr failure_;
    bool is_over_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace grafwire
