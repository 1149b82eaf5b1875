// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sensotwin::twin {

/// Calls `work(0)` .. `work(count - 1)`, each once, on `jobs` threads, in no particular order: work writes to
/// a place of its own by index, and whoever reduces does so afterwards in the order of the index.
/// \param progress  called under a lock with the number done and `count`; work ends early once it returns
///   false. May be empty
/// \returns whether all is done
[[nodiscard]] inline bool run_in_parallel(int count, int jobs, const std::function<void(int)>& work,
                                          const std::function<bool(int, int)>& progress) {
  std::atomic<int> next{0};
  std::atomic<bool> may_go_on{true};
  std::mutex progress_mutex;
  int done = 0;
  const auto worker = [&] {
    for (int i = next++; i < count && may_go_on; i = next++) {
      work(i);
      const std::scoped_lock lock{progress_mutex};
      ++done;
      if (progress && may_go_on && !progress(done, count)) may_go_on = false;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int i = 1; i < std::min(jobs, count); ++i) threads.emplace_back(worker);
    worker();
  }
  return done == count;
}

}  // namespace sensotwin::twin
