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
/// a place of its own by index, and whoever reduces does so afterwards in the order of the index. \param
/// progress  called under a lock with the number done and `count`; may be empty
inline void run_in_parallel(int count, int jobs, const std::function<void(int)>& work,
                            const std::function<void(int, int)>& progress) {
  std::atomic<int> next{0};
  std::mutex progress_mutex;
  int done = 0;
  const auto worker = [&] {
    for (int i = next++; i < count; i = next++) {
      work(i);
      if (!progress) continue;
      const std::scoped_lock lock{progress_mutex};
      progress(++done, count);
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < std::min(jobs, count); ++i) threads.emplace_back(worker);
  worker();
}

}  // namespace sensotwin::twin
