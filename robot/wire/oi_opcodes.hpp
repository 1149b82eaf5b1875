// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>

/// Roomba's serial interface. Sources: iRobot Create 2 Open Interface (2016), pages 8 to 23; Roomba Serial
/// Command Interface (SCI, 2005) for the 400 series.
namespace sensotwin::robot::oi {

enum class Opcode : std::uint8_t {
  kReset = 7,
  kStart = 128,
  kBaud = 129,
  kControl = 130,
  kSafe = 131,
  kFull = 132,
  kPower = 133,
  kSpot = 134,
  kClean = 135,
  kMax = 136,
  kDrive = 137,
  kMotors = 138,
  kLeds = 139,
  kSong = 140,
  kPlay = 141,
  kSensors = 142,
  kSeekDock = 143,
  kPwmMotors = 144,
  kDriveDirect = 145,
  kDrivePwm = 146,
  kStream = 148,
  kQueryList = 149,
  kPauseResume = 150,
  kSchedulingLeds = 162,
  kDigitLedsRaw = 163,
  kDigitLedsAscii = 164,
  kButtons = 165,
  kSchedule = 167,
  kSetDayTime = 168,
  kStop = 173,
};

/// As packet 35 numbers them.
enum class Mode : std::uint8_t { kOff, kPassive, kSafe, kFull };

/// Modes in which a command acts, one bit each. Its data bytes are consumed in every mode.
using ModeSet = std::uint8_t;
[[nodiscard]] constexpr ModeSet mode_set(std::initializer_list<Mode> modes) {
  unsigned set = 0;
  for (const Mode mode : modes) {
    set |= 1u << static_cast<unsigned>(mode);
  }
  return static_cast<ModeSet>(set);
}
[[nodiscard]] constexpr bool contains(ModeSet set, Mode mode) {
  return ((set >> static_cast<unsigned>(mode)) & 1u) != 0;
}

/// What follows the fixed data bytes.
enum class Tail : std::uint8_t {
  kNone,
  kNotes,  ///< two bytes for each of the notes that data byte 2 counts (140)
  kIds,    ///< one byte for each of the packets that data byte 1 counts (148, 149)
};

struct OpcodeInfo {
  Opcode opcode{};
  std::uint8_t data_bytes{0};  ///< always present
  Tail tail{Tail::kNone};
  ModeSet modes{0};
  std::optional<Mode> becomes;  ///< mode afterwards; nothing: as before
};

/// The commands that one kind of robot knows.
class OpcodeTable {
 public:
  constexpr OpcodeTable(std::initializer_list<OpcodeInfo> infos) {
    for (const OpcodeInfo& info : infos) {
      infos_[count_++] = info;
      index_[static_cast<std::uint8_t>(info.opcode)] = count_;
    }
  }
  /// \returns nullptr when the robot does not know `code`: it skips that one byte.
  [[nodiscard]] constexpr const OpcodeInfo* find(std::uint8_t code) const {
    return index_[code] == 0 ? nullptr : &infos_[index_[code] - 1u];
  }

 private:
  std::array<OpcodeInfo, 40> infos_{};
  std::array<std::uint8_t, 256> index_{};  ///< position in infos_, from 1; 0: unknown
  std::uint8_t count_{0};
};

inline constexpr ModeSet kAnyMode = mode_set({Mode::kOff, Mode::kPassive, Mode::kSafe, Mode::kFull});
inline constexpr ModeSet kWhenOn = mode_set({Mode::kPassive, Mode::kSafe, Mode::kFull});
inline constexpr ModeSet kWhenControlled = mode_set({Mode::kSafe, Mode::kFull});

/// Create 2, Roomba 500 and 600. Start is listed there for passive, safe and full; the mode text (page 7)
/// says that it is what an off robot listens for.
inline constexpr OpcodeTable kOpenInterface{
    {Opcode::kReset, 0, Tail::kNone, kAnyMode, Mode::kOff},
    {Opcode::kStart, 0, Tail::kNone, kAnyMode, Mode::kPassive},
    {Opcode::kBaud, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kControl, 0, Tail::kNone, kWhenOn, Mode::kSafe},
    {Opcode::kSafe, 0, Tail::kNone, kWhenOn, Mode::kSafe},
    {Opcode::kFull, 0, Tail::kNone, kWhenOn, Mode::kFull},
    {Opcode::kPower, 0, Tail::kNone, kWhenOn, Mode::kPassive},
    {Opcode::kSpot, 0, Tail::kNone, kWhenOn, Mode::kPassive},
    {Opcode::kClean, 0, Tail::kNone, kWhenOn, Mode::kPassive},
    {Opcode::kMax, 0, Tail::kNone, kWhenOn, Mode::kPassive},
    {Opcode::kDrive, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kMotors, 1, Tail::kNone, kWhenControlled, {}},
    {Opcode::kLeds, 3, Tail::kNone, kWhenControlled, {}},
    {Opcode::kSong, 2, Tail::kNotes, kWhenOn, {}},
    {Opcode::kPlay, 1, Tail::kNone, kWhenControlled, {}},
    {Opcode::kSensors, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kSeekDock, 0, Tail::kNone, kWhenOn, Mode::kPassive},
    {Opcode::kPwmMotors, 3, Tail::kNone, kWhenControlled, {}},
    {Opcode::kDriveDirect, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kDrivePwm, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kStream, 1, Tail::kIds, kWhenOn, {}},
    {Opcode::kQueryList, 1, Tail::kIds, kWhenOn, {}},
    {Opcode::kPauseResume, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kSchedulingLeds, 2, Tail::kNone, kWhenControlled, {}},
    {Opcode::kDigitLedsRaw, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kDigitLedsAscii, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kButtons, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kSchedule, 15, Tail::kNone, kWhenOn, {}},
    {Opcode::kSetDayTime, 3, Tail::kNone, kWhenOn, {}},
    {Opcode::kStop, 0, Tail::kNone, kWhenOn, Mode::kOff},
};

/// Roomba 400 (SCI, 2005). Control is the only way out of passive; Safe only leads back from full, Full only
/// on from safe; power and cleaning need safe or full. Dock (143) came with the 2006 edition.
inline constexpr OpcodeTable kSerialCommandInterface{
    {Opcode::kStart, 0, Tail::kNone, kAnyMode, Mode::kPassive},
    {Opcode::kBaud, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kControl, 0, Tail::kNone, mode_set({Mode::kPassive}), Mode::kSafe},
    {Opcode::kSafe, 0, Tail::kNone, mode_set({Mode::kFull}), Mode::kSafe},
    {Opcode::kFull, 0, Tail::kNone, mode_set({Mode::kSafe}), Mode::kFull},
    {Opcode::kPower, 0, Tail::kNone, kWhenControlled, Mode::kPassive},
    {Opcode::kSpot, 0, Tail::kNone, kWhenControlled, Mode::kPassive},
    {Opcode::kClean, 0, Tail::kNone, kWhenControlled, Mode::kPassive},
    {Opcode::kMax, 0, Tail::kNone, kWhenControlled, Mode::kPassive},
    {Opcode::kDrive, 4, Tail::kNone, kWhenControlled, {}},
    {Opcode::kMotors, 1, Tail::kNone, kWhenControlled, {}},
    {Opcode::kLeds, 3, Tail::kNone, kWhenControlled, {}},
    {Opcode::kSong, 2, Tail::kNotes, kWhenOn, {}},
    {Opcode::kPlay, 1, Tail::kNone, kWhenControlled, {}},
    {Opcode::kSensors, 1, Tail::kNone, kWhenOn, {}},
    {Opcode::kSeekDock, 0, Tail::kNone, kWhenControlled, Mode::kPassive},
};

/// Baud codes 0 to 11 of command 129 (page 9).
inline constexpr std::array<int, 12> kBauds{300,   600,   1200,  2400,  4800,  9600,
                                            14400, 19200, 28800, 38400, 57600, 115200};

}  // namespace sensotwin::robot::oi
