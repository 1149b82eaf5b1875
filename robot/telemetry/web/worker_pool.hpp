// SPDX-License-Identifier: MIT
#pragma once

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sensotwin::robot {

/// A thread for each connection, up to a number: they are begun when they are first needed and then kept, and
/// run at a lower priority than the robot's loop. What comes beyond runs in the thread that accepts, where it
/// is turned away: nothing waits in memory with its socket open.
class WorkerPool : public httplib::TaskQueue {
 public:
  explicit WorkerPool(std::size_t workers) : most_(workers) {}

  void enqueue(std::function<void()> job) override;
  void shutdown() override;

 private:
  void work();

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable awake_;
  std::deque<std::function<void()>> jobs_;
  std::size_t idle_{0};
  bool ending_{false};
  std::vector<std::thread> threads_;
};

}  // namespace sensotwin::robot
