// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "robot/base/bytes.hpp"

/// Exchanges between a driver and a card reader. The driver's tests expect the commands and give the
/// responses; the emulator's tests give the commands and expect the responses.
namespace sensotwin::testing {

using robot::Bytes;

struct CardExchange {
  Bytes command;
  Bytes response;
};
struct CardTranscript {
  std::string_view name;
  std::vector<CardExchange> exchanges;
};

/// The tag of all transcripts: its UID, blocks 0 to 2 hold kOldData, block 9 is locked, the rest is zero.
inline constexpr std::uint64_t kTranscriptUid = 0xE004'0100'0000'002Au;
inline const Bytes kOldData{0x01, 0x01, 0x00, 0x00, 0, 0, 0, 0, 0, 0, 0, 0};
inline const Bytes kNewData{0x58, 0x01, 0x20, 0x26, 0x00, 0x03, 0xFF, 0xFE, 0x00, 0x07, 0x79, 0xB5};

inline Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

inline const CardExchange kSaysItsUid{{0xFF, 0xCA, 0x00, 0x00, 0x00},
                                      {0xE0, 0x04, 0x01, 0x00, 0x00, 0x00, 0x00, 0x2A, 0x90, 0x00}};
inline const Bytes kReadRecord{0xFF, 0xB0, 0x00, 0x00, 0x0C};
inline const CardExchange kGivesOldData{kReadRecord, joined({kOldData, {0x90, 0x00}})};
inline const CardExchange kGivesNewData{kReadRecord, joined({kNewData, {0x90, 0x00}})};
inline const CardExchange kTakesNewData{joined({{0xFF, 0xD6, 0x00, 0x00, 0x0C}, kNewData}), {0x90, 0x00}};

/// A tag comes into the field.
inline const CardTranscript kIdentifyAndRead{"identify and read", {kSaysItsUid, kGivesOldData}};
/// The driver is asked to write kNewData to blocks 0 to 2.
inline const CardTranscript kWriteAndVerify{"write and verify",
                                            {kSaysItsUid, kTakesNewData, kGivesNewData, kSaysItsUid}};
/// ... kNewData's first block to the locked block 9.
inline const CardTranscript kWriteLocked{
    "write a locked block",
    {kSaysItsUid, {{0xFF, 0xD6, 0x00, 0x09, 0x04, 0x58, 0x01, 0x20, 0x26}, {0x69, 0x86}}}};
/// ... kNewData's first block to block 28, which does not exist.
inline const CardTranscript kWriteBeyond{
    "write beyond the last block",
    {kSaysItsUid, {{0xFF, 0xD6, 0x00, 0x1C, 0x04, 0x58, 0x01, 0x20, 0x26}, {0x6A, 0x82}}}};
/// ... kNewData's first two blocks to blocks 3 and 4, by a driver that moves one block at a time.
inline const CardTranscript kWriteBlockwise{
    "write block by block",
    {kSaysItsUid,
     {{0xFF, 0xD6, 0x00, 0x03, 0x04, 0x58, 0x01, 0x20, 0x26}, {0x90, 0x00}},
     kSaysItsUid,
     {{0xFF, 0xD6, 0x00, 0x04, 0x04, 0x00, 0x03, 0xFF, 0xFE}, {0x90, 0x00}},
     {{0xFF, 0xB0, 0x00, 0x03, 0x04}, {0x58, 0x01, 0x20, 0x26, 0x90, 0x00}},
     {{0xFF, 0xB0, 0x00, 0x04, 0x04}, {0x00, 0x03, 0xFF, 0xFE, 0x90, 0x00}},
     kSaysItsUid}};

}  // namespace sensotwin::testing
