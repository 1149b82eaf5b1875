// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/time.hpp"

/// A journal: all that went over the wires of one run, and when; enough to run the program again.
///
///     "SensoTwin journal 1\n" | length | robot file, YAML | block | block ...
///     block:   kind ('T' or 'E') | length | payload | check
///     payload: nanoseconds since the block before (the first: since the program's start) | record | record
///     .. record:  wire * 16 + what | length | bytes          length and bytes only with what has_bytes()
///
/// Lengths and nanoseconds are unsigned LEB128; `check` is FNV-1a of the payload, 32 bits, low byte first. A
/// block is one step of the program ('T') or its end ('E', shut_down()); records stand in the order in which
/// the program asked, which is the order in which a replay answers. What a wire says is written down when it
/// differs from what it said before: an empty read, a state unchanged take no room. A Roomba's stream makes
/// 9 kB a second (docs/sensobot.md).
///
/// A file that ends in mid-block was cut off by a crash; the blocks before it are good.
namespace sensotwin::robot {

inline constexpr std::string_view kJournalMagic = "SensoTwin journal 1\n";

enum class Wire : std::uint8_t { kBase, kSensors, kUhfReader, kFloorReader, kForwardReader };
inline constexpr std::size_t kWires = 5;
/// For people.
[[nodiscard]] std::string_view name_of(Wire wire);

enum class WireWord : std::uint8_t {
  kUp,              ///< a ByteLink's is_up()
  kDown,            ///
  kRead,            ///< bytes: what a read gave
  kWritten,         ///< bytes: what was written
  kWriteRefused,    ///< bytes: what was refused, the link being down
  kNoReader,        ///< a CardLink's presence()
  kEmpty,           ///
  kPresent,         ///
  kBegun,           ///< bytes: a command APDU
  kBeginRefused,    ///< bytes: a command APDU
  kAnswer,          ///< bytes: a response APDU
  kAnswerRemoved,   ///< CardError, in its order
  kAnswerNoReader,  ///
  kAnswerTimeout,   ///
};
inline constexpr std::uint8_t kWireWords = 14;
[[nodiscard]] bool has_bytes(WireWord word);

struct WireRecord {
  Wire wire{Wire::kBase};
  WireWord word{WireWord::kUp};
  Bytes bytes;
  bool operator==(const WireRecord&) const = default;
};
/// "base: written 145 0 100 0 100".
[[nodiscard]] std::string text_of(const WireRecord& record);

struct JournalBlock {
  bool end{false};  ///< shut_down(), not a step
  Instant at;
  std::vector<WireRecord> records;
};

struct Journal {
  std::string robot_file;  ///< YAML
  std::vector<JournalBlock> blocks;
  std::size_t bytes_torn{0};  ///< at the end of the file, of no whole block
};

}  // namespace sensotwin::robot
