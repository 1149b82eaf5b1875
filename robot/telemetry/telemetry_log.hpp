// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

namespace sensotwin::robot {

/// One thing that a page is to know: the newest of its key replaces all older ones.
struct TelemetryMessage {
  std::string key;   ///< "0/tile/3,4", "0/pose": what it is about
  std::string json;  ///< an object
};

/// All that a page must be told to draw what has happened so far, in the order of its happening: of each key
/// only the newest message is kept. Whoever has read up to a number reads on from there; whoever begins at 0
/// gets the whole picture. So a slow reader misses intermediate poses and nothing else, a late one misses
/// nothing, and neither costs memory. Safe for many threads.
class TelemetryLog {
 public:
  /// \param epoch  tells this log from those of other runs  \param most  keys; messages of further ones are
  /// counted and dropped. Chosen: a floor of 100 m by 100 m of tiles and their events
  explicit TelemetryLog(std::string epoch, std::size_t most = 100'000);

  /// In this order. The messages are moved from.
  void append(std::span<TelemetryMessage> messages);

  struct Batch {
    std::string text;  ///< whole server-sent events
    std::uint64_t last{0};
  };
  /// Messages behind number `last`, at least one if there is any, about `bytes` of them.
  [[nodiscard]] Batch after(std::uint64_t last, std::size_t bytes) const;
  /// Until there is something behind `last`, the log is closed, or patience ends.
  void wait(std::uint64_t last, std::chrono::milliseconds patience) const;

  /// Nothing more will come; who waits is woken.
  void close();
  [[nodiscard]] bool closed() const;
  [[nodiscard]] std::uint64_t last() const;
  [[nodiscard]] std::uint64_t dropped() const;

  /// The number in a Last-Event-ID of this log; 0, the beginning, for those of others and for anything else.
  [[nodiscard]] std::uint64_t number_of(std::string_view event_id) const;

 private:
  struct Entry {
    std::string key;
    std::string event;
  };
  void append_one(TelemetryMessage& message);

  const std::string epoch_;
  const std::size_t most_;
  mutable std::mutex mutex_;
  mutable std::condition_variable news_;
  std::map<std::uint64_t, Entry> entries_;
  std::unordered_map<std::string, std::uint64_t> newest_;  ///< looked up only
  std::uint64_t last_{0};
  std::uint64_t dropped_{0};
  bool closed_{false};
};

}  // namespace sensotwin::robot
