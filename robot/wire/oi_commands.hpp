// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "robot/base/bytes.hpp"
#include "robot/base/result.hpp"
#include "robot/wire/oi_opcodes.hpp"

/// The commands of the Open Interface as values. Each struct lists its data bytes once, in the order of the
/// wire and with the range the manual allows; encoder, decoder and range check are made from that list.
namespace sensotwin::robot::oi {

/// Values the manual allows.
struct Range {
  int min{0};
  int max{255};
  bool or_straight{false};  ///< also the two radii that mean straight
};

/// Special radii of Drive (page 13).
inline constexpr std::int16_t kStraight = -32768;    ///< 0x8000
inline constexpr std::int16_t kStraightToo = 32767;  ///< 0x7FFF; Open Interface only
inline constexpr std::int16_t kTurnClockwise = -1;   ///< in place
inline constexpr std::int16_t kTurnCounterClockwise = 1;

template <Opcode kCode>
struct NoData {
  static constexpr Opcode kOpcode = kCode;
  bool operator==(const NoData&) const = default;
  static void fields(auto&, auto&&) {}
};
using Reset = NoData<Opcode::kReset>;
using Start = NoData<Opcode::kStart>;
using Control = NoData<Opcode::kControl>;
using Safe = NoData<Opcode::kSafe>;
using Full = NoData<Opcode::kFull>;
using Power = NoData<Opcode::kPower>;
using Spot = NoData<Opcode::kSpot>;
using Clean = NoData<Opcode::kClean>;
using Max = NoData<Opcode::kMax>;
using SeekDock = NoData<Opcode::kSeekDock>;
using Stop = NoData<Opcode::kStop>;

struct Baud {
  static constexpr Opcode kOpcode = Opcode::kBaud;
  std::uint8_t code{11};  ///< index into kBauds
  bool operator==(const Baud&) const = default;
  static void fields(auto& self, auto&& each) { each(self.code, Range{0, 11}); }
};

struct Drive {
  static constexpr Opcode kOpcode = Opcode::kDrive;
  std::int16_t velocity_mm_s{0};      ///< mean of both wheels
  std::int16_t radius_mm{kStraight};  ///< turning centre to robot centre, positive left
  bool operator==(const Drive&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.velocity_mm_s, Range{-500, 500});
    each(self.radius_mm, Range{-2000, 2000, true});
  }
};

struct DriveDirect {
  static constexpr Opcode kOpcode = Opcode::kDriveDirect;
  std::int16_t right_mm_s{0};
  std::int16_t left_mm_s{0};
  bool operator==(const DriveDirect&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.right_mm_s, Range{-500, 500});
    each(self.left_mm_s, Range{-500, 500});
  }
};

struct DrivePwm {
  static constexpr Opcode kOpcode = Opcode::kDrivePwm;
  std::int16_t right{0};  ///< duty cycle / 255
  std::int16_t left{0};
  bool operator==(const DrivePwm&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.right, Range{-255, 255});
    each(self.left, Range{-255, 255});
  }
};

struct Motors {
  static constexpr Opcode kOpcode = Opcode::kMotors;
  static constexpr std::uint8_t kSideBrush = 1;
  static constexpr std::uint8_t kVacuum = 2;
  static constexpr std::uint8_t kMainBrush = 4;
  static constexpr std::uint8_t kSideBrushClockwise = 8;
  static constexpr std::uint8_t kMainBrushOutward = 16;
  std::uint8_t bits{0};
  bool operator==(const Motors&) const = default;
  static void fields(auto& self, auto&& each) { each(self.bits, Range{0, 31}); }
};

struct PwmMotors {
  static constexpr Opcode kOpcode = Opcode::kPwmMotors;
  std::int8_t main_brush{0};  ///< duty cycle / 128, positive inward
  std::int8_t side_brush{0};  ///< duty cycle / 128, positive counter-clockwise
  std::uint8_t vacuum{0};     ///< duty cycle / 128
  bool operator==(const PwmMotors&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.main_brush, Range{-127, 127});
    each(self.side_brush, Range{-127, 127});
    each(self.vacuum, Range{0, 127});
  }
};

struct Leds {
  static constexpr Opcode kOpcode = Opcode::kLeds;
  std::uint8_t bits{0};       ///< debris 1, spot 2, dock 4, check robot 8
  std::uint8_t color{0};      ///< of the power LED: 0 green .. 255 red
  std::uint8_t intensity{0};  ///< of the power LED
  bool operator==(const Leds&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.bits, Range{});
    each(self.color, Range{});
    each(self.intensity, Range{});
  }
};

struct SchedulingLeds {
  static constexpr Opcode kOpcode = Opcode::kSchedulingLeds;
  std::uint8_t weekdays{0};
  std::uint8_t scheduling{0};
  bool operator==(const SchedulingLeds&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.weekdays, Range{});
    each(self.scheduling, Range{});
  }
};

/// Segments of the four digits, leftmost (digit 3) first.
struct DigitLedsRaw {
  static constexpr Opcode kOpcode = Opcode::kDigitLedsRaw;
  std::array<std::uint8_t, 4> segments{};
  bool operator==(const DigitLedsRaw&) const = default;
  static void fields(auto& self, auto&& each) {
    for (auto& digit : self.segments) {
      each(digit, Range{});
    }
  }
};

/// Characters of the four digits, leftmost (digit 3) first.
struct DigitLedsAscii {
  static constexpr Opcode kOpcode = Opcode::kDigitLedsAscii;
  std::array<std::uint8_t, 4> characters{' ', ' ', ' ', ' '};
  bool operator==(const DigitLedsAscii&) const = default;
  static void fields(auto& self, auto&& each) {
    for (auto& character : self.characters) {
      each(character, Range{32, 126});
    }
  }
};

struct Buttons {
  static constexpr Opcode kOpcode = Opcode::kButtons;
  std::uint8_t bits{0};  ///< as packet 18
  bool operator==(const Buttons&) const = default;
  static void fields(auto& self, auto&& each) { each(self.bits, Range{}); }
};

struct Schedule {
  static constexpr Opcode kOpcode = Opcode::kSchedule;
  struct Time {
    std::uint8_t hour{0};
    std::uint8_t minute{0};
    bool operator==(const Time&) const = default;
  };
  std::uint8_t days{0};         ///< Sunday 1, Monday 2 .. Saturday 64
  std::array<Time, 7> times{};  ///< Sunday first
  bool operator==(const Schedule&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.days, Range{0, 127});
    for (auto& time : self.times) {
      each(time.hour, Range{0, 23});
      each(time.minute, Range{0, 59});
    }
  }
};

struct SetDayTime {
  static constexpr Opcode kOpcode = Opcode::kSetDayTime;
  std::uint8_t day{0};  ///< Sunday 0
  std::uint8_t hour{0};
  std::uint8_t minute{0};
  bool operator==(const SetDayTime&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.day, Range{0, 6});
    each(self.hour, Range{0, 23});
    each(self.minute, Range{0, 59});
  }
};

struct Song {
  static constexpr Opcode kOpcode = Opcode::kSong;
  static constexpr std::size_t kMaxNotes = 16;
  struct Note {
    std::uint8_t midi{0};  ///< 31..127 sound, anything else is a rest
    std::uint8_t sixty_fourths_s{0};
    bool operator==(const Note&) const = default;
  };
  std::uint8_t number{0};
  std::uint8_t length{0};
  std::array<Note, kMaxNotes> notes{};  ///< the first `length` count
  bool operator==(const Song&) const = default;
  /// The text says four songs, the range of the same page five.
  static void fields(auto& self, auto&& each) {
    each(self.number, Range{0, 4});
    each(self.length, Range{1, kMaxNotes});
    for (std::size_t i = 0; i < self.length && i < kMaxNotes; ++i) {
      each(self.notes[i].midi, Range{});
      each(self.notes[i].sixty_fourths_s, Range{});
    }
  }
};

struct Play {
  static constexpr Opcode kOpcode = Opcode::kPlay;
  std::uint8_t number{0};
  bool operator==(const Play&) const = default;
  static void fields(auto& self, auto&& each) { each(self.number, Range{0, 4}); }
};

struct Sensors {
  static constexpr Opcode kOpcode = Opcode::kSensors;
  std::uint8_t id{0};  ///< packet or group
  bool operator==(const Sensors&) const = default;
  static void fields(auto& self, auto&& each) { each(self.id, Range{0, 107}); }
};

/// Packet ids asked for. A list of none ends a stream.
template <Opcode kCode>
struct PacketList {
  static constexpr Opcode kOpcode = kCode;
  std::uint8_t count{0};
  std::array<std::uint8_t, 255> id{};  ///< the first `count` count, the others are 0
  PacketList() = default;
  /// \pre ids.size() <= 255
  explicit PacketList(ByteView wanted) : count(static_cast<std::uint8_t>(wanted.size())) {
    assert(wanted.size() <= id.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      id[i] = wanted[i];
    }
  }
  /// Valid while this list is.
  [[nodiscard]] ByteView ids() const { return {id.data(), count}; }
  bool operator==(const PacketList&) const = default;
  static void fields(auto& self, auto&& each) {
    each(self.count, Range{});
    for (std::size_t i = 0; i < self.count; ++i) {
      each(self.id[i], Range{0, 107});
    }
  }
};
using QueryList = PacketList<Opcode::kQueryList>;
using Stream = PacketList<Opcode::kStream>;

struct PauseResume {
  static constexpr Opcode kOpcode = Opcode::kPauseResume;
  std::uint8_t running{0};  ///< 0 pauses, 1 goes on with the last list
  bool operator==(const PauseResume&) const = default;
  static void fields(auto& self, auto&& each) { each(self.running, Range{0, 1}); }
};

using Command =
    std::variant<Reset, Start, Baud, Control, Safe, Full, Power, Spot, Clean, Max, Drive, Motors, Leds, Song,
                 Play, Sensors, SeekDock, PwmMotors, DriveDirect, DrivePwm, Stream, QueryList, PauseResume,
                 SchedulingLeds, DigitLedsRaw, DigitLedsAscii, Buttons, Schedule, SetDayTime, Stop>;

/// The longest command that can be encoded: a list of 255 packets.
inline constexpr std::size_t kMaxCommandBytes = 257;

enum class CommandError : std::uint8_t {
  kUnknownOpcode,  ///< the byte is no command of this robot; it alone was skipped
  kSongTooLong,    ///< more than 16 notes were announced; all their bytes were consumed
  kNoRoom,         ///< the command does not fit into the span; the span's content is unspecified
};

[[nodiscard]] Opcode opcode_of(const Command& command);
/// All values lie where the manual allows them.
[[nodiscard]] bool in_range(const Command& command);
/// The same command with each value moved to the nearest allowed one.
[[nodiscard]] Command clamped(Command command);

/// Writes opcode and data bytes, whatever their values. \returns the number of bytes, or kNoRoom
[[nodiscard]] Result<std::size_t, CommandError> encode(const Command& command, std::span<std::uint8_t> into);
/// The same in a container of its own; for where no time presses.
[[nodiscard]] Bytes encode(const Command& command);

/// Rebuilds commands from single bytes as the robot's own parser does: it waits for missing data bytes for
/// ever, in every mode, and skips bytes that begin no command (page 8, note). Never allocates.
class CommandDecoder {
 public:
  /// \param table must outlive the decoder
  explicit CommandDecoder(const OpcodeTable& table = kOpenInterface) : table_(&table) {}
  /// Feeds one byte.
  /// \returns nothing while a command is incomplete, else the command, or
  /// - kUnknownOpcode: the byte begins no command; the next byte may
  /// - kSongTooLong: a whole song was consumed that cannot be played
  [[nodiscard]] std::optional<Result<Command, CommandError>> push(std::uint8_t byte);
  /// Data bytes are awaited.
  [[nodiscard]] bool waiting() const { return pending_ != nullptr; }
  /// Forgets an incomplete command, as a power cycle does.
  void reset() { pending_ = nullptr; }

 private:
  [[nodiscard]] std::size_t bytes_needed() const;
  [[nodiscard]] Result<Command, CommandError> complete();

  const OpcodeTable* table_;
  const OpcodeInfo* pending_{nullptr};
  std::size_t held_{0};
  std::array<std::uint8_t, 2 + 2 * 255> data_{};  ///< the longest: a song that announces 255 notes
};

}  // namespace sensotwin::robot::oi
