// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/worker_pool.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <system_error>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Pages give way to the robot. Chosen: half of what there is, a ninth of the loop's share when both want
/// all.
constexpr int kNiceness = 10;

void give_way() {
  // Linux counts priorities by thread. Without the right to lower itself it runs as it is.
  (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
}

}  // namespace

void WorkerPool::enqueue(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    bool taken = idle_ > jobs_.size();
    if (!taken && threads_.size() < most_) {
      try {
        threads_.emplace_back([this] { work(); });
        taken = true;
      } catch (const std::system_error&) {
        taken = false;  // the system has no thread left
      }
    }
    if (taken) {
      jobs_.push_back(std::move(job));
      awake_.notify_one();
      return;
    }
  }
  job();
}

void WorkerPool::work() {
  give_way();
  std::unique_lock lock(mutex_);
  while (true) {
    ++idle_;
    awake_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
    --idle_;
    if (jobs_.empty()) {
      return;
    }
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
}

void WorkerPool::shutdown() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  awake_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

}  // namespace sensotwin::robot
