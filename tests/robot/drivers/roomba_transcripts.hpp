// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "robot/base/bytes.hpp"

/// What is said on the wire between the Roomba driver and a robot, byte for byte and written out by hand. The
/// driver must say the one half to the other, and the emulated mainboard the other half to the one.
namespace sensotwin::robot::transcripts {

struct Exchange {
  std::string name;
  Bytes to_robot;
  /// The robot's next words at its next sensor update; nothing when it stays silent.
  Bytes from_robot;
};

inline Bytes operator+(Bytes left, const Bytes& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

/// Of a robot that stands on a floor: 16 000 mV, -200 mA, 25 C, 2000 of 2696 mAh, cliff signals 2400.
struct Frame {
  std::uint8_t mode{2};
  std::uint8_t bumps_and_wheel_drops{0};
  std::int16_t requested_mm_s_right{0};
  std::int16_t requested_mm_s_left{0};
  std::uint16_t counts_left{0};
  std::uint16_t counts_right{0};
};

inline const Bytes kStreamRequest{148, 42, 7,  8,  9,  10, 11, 12, 13, 14, 15, 17, 18, 21, 22,
                                  23,  24, 25, 26, 27, 28, 29, 30, 31, 34, 35, 41, 42, 43, 44,
                                  45,  46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58};

/// The stream frame a robot sends to that request.
inline Bytes bytes_of(const Frame& frame) {
  const auto be = [](int value) {
    const auto bits = static_cast<std::uint16_t>(value);
    return Bytes{high_byte(bits), low_byte(bits)};
  };
  const Bytes payload = Bytes{7,  frame.bumps_and_wheel_drops,
                              8,  0,
                              9,  0,
                              10, 0,
                              11, 0,
                              12, 0,
                              13, 0,
                              14, 0,
                              15, 0,
                              17, 0,
                              18, 0,
                              21, 0,
                              22} +
                        be(16000) + Bytes{23} + be(-200) + Bytes{24, 25, 25} + be(2000) + Bytes{26} +
                        be(2696) + Bytes{27, 0, 0, 28} + be(2400) + Bytes{29} + be(2400) + Bytes{30} +
                        be(2400) + Bytes{31} + be(2400) + Bytes{34, 0, 35, frame.mode, 41} +
                        be(frame.requested_mm_s_right) + Bytes{42} + be(frame.requested_mm_s_left) +
                        Bytes{43} + be(frame.counts_left) + Bytes{44} + be(frame.counts_right) +
                        Bytes{45, 0,  46, 0,  0, 47, 0, 0, 48, 0, 0, 49, 0, 0, 50, 0, 0, 51, 0,
                              0,  52, 0,  53, 0, 54, 0, 0, 55, 0, 0, 56, 0, 0, 57, 0, 0, 58, 0};
  Bytes out = Bytes{19, static_cast<std::uint8_t>(payload.size())} + payload;
  unsigned sum = 0;
  for (const std::uint8_t byte : out) {
    sum += byte;
  }
  out.push_back(static_cast<std::uint8_t>(0u - sum));
  return out;
}

inline const Exchange kStartInSafeMode{"start in safe mode", Bytes{128} + kStreamRequest + Bytes{131},
                                       bytes_of({.mode = 2})};
inline const Exchange kStartInFullMode{"start in full mode", Bytes{128} + kStreamRequest + Bytes{132},
                                       bytes_of({.mode = 3})};
/// Right +200 mm/s first, then left -200.
inline const Exchange kTurnLeft{"turn left on the spot",
                                {145, 0, 200, 255, 56},
                                bytes_of({.requested_mm_s_right = 200, .requested_mm_s_left = -200})};
inline const Exchange kStop{"stop", {145, 0, 0, 0, 0}, bytes_of({})};
/// The robot drops its left wheel, stops by itself and says so; the driver confirms with a stop.
inline const Exchange kWheelDrop{
    "wheel drop", {145, 0, 0, 0, 0}, bytes_of({.mode = 1, .bumps_and_wheel_drops = 8})};
inline const Exchange kShutDown{"shut down", {145, 0, 0, 0, 0, 128, 173}, {}};

/// SCI: polled, 26 bytes without header, mode or checksum.
inline const Exchange kSciStart{"start a Roomba 400", {128, 130}, {}};
inline const Exchange kSciPoll{
    "poll a Roomba 400", {142, 0}, {0, 0, 0, 0, 0,    0,    0,    0,    0,  0,    0,    0,    0,
                                    0, 0, 0, 0, 0x3E, 0x80, 0xFF, 0x38, 25, 0x07, 0xD0, 0x0A, 0x88}};
inline const Exchange kSciStraight{"drive a Roomba 400 straight", {137, 0, 200, 128, 0}, {}};

}  // namespace sensotwin::robot::transcripts
