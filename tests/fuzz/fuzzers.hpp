// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "robot/base/bytes.hpp"

/// What the fuzzers run. Each takes any bytes, hands them to everything that reads bytes of that kind, and
/// throws PropertyBroken when something that holds for all bytes does not hold for these. libfuzzer_entry.cpp
/// gives one of them to libFuzzer; corpus_test.cpp runs all of them on the files kept in corpus/.
namespace sensotwin::fuzz {

/// Open Interface and SCI: command and stream decoders, the driver of a Roomba, the emulated mainboard.
void oi(robot::ByteView input);
/// LLRP: frames, messages, the driver of a UHF reader, the emulated reader.
void llrp(robot::ByteView input);
/// NMEA 0183: sentences, headings, distances, the driver of a compass.
void nmea(robot::ByteView input);
/// Storage-card APDUs and tag records, the driver of a tag reader, the emulated card reader.
void apdu(robot::ByteView input);
/// Scenes, as YAML.
void scene(robot::ByteView input);
/// Hallway maps and robot files, as YAML.
void settings(robot::ByteView input);
/// Journals.
void journal(robot::ByteView input);

struct Fuzzer {
  std::string_view name;  ///< of its folder in corpus/, too
  void (*run)(robot::ByteView input);
};
inline constexpr std::array<Fuzzer, 7> kFuzzers{{{"oi", oi},
                                                 {"llrp", llrp},
                                                 {"nmea", nmea},
                                                 {"apdu", apdu},
                                                 {"scene", scene},
                                                 {"settings", settings},
                                                 {"journal", journal}}};

}  // namespace sensotwin::fuzz
