// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/epc.hpp"

/// What is said between the UHF driver and a reader, byte for byte and written out by hand from LLRP 1.0.1,
/// 16 and Impinj's definitions. The driver must say the one half to the other, and the emulated reader the
/// other half to the one.
namespace sensotwin::robot::transcripts {

/// Bytes from hexadecimal digits; blanks are for the eye.
[[nodiscard]] inline Bytes hex(std::string_view text) {
  Bytes out;
  int held = -1;
  for (const char c : text) {
    if (c == ' ' || c == '\n') {
      continue;
    }
    const int digit = c <= '9' ? c - '0' : c - 'a' + 10;
    if (held < 0) {
      held = digit;
    } else {
      out.push_back(static_cast<std::uint8_t>(held * 16 + digit));
      held = -1;
    }
  }
  return out;
}

struct UhfExchange {
  std::string name;
  Bytes to_reader;
  Bytes from_reader;
};

/// 1 700 000 000 s of UTC, in microseconds: 0x00060a24181e4000. Message ids of the reader count from 1, those
/// of the client too.
inline const Bytes kUhfGreeting =
    hex("043f 00000020 00000001"
        "00f6 0016  0080 000c 00060a24181e4000  0100 0006 0000");

inline const Bytes kUhfAskCapabilities = hex("0401 0000000b 00000001 00");
/// Of a reader with one antenna and a table of two channels, 915.25 and 902.75 MHz: as short as LLRP allows.
inline const Bytes kUhfShortCapabilities =
    hex("040b 000000a6 00000001"
        "011f 0008 0000 0000"
        "0089 002b 0001 4000 0000651a 001e886a 0000  008b 0008 0001 0000  008d 0008 0004 0004"
        "          008c 0009 0001 0001 01  "
        "008e 001c 00 01 0000 00000001 00000020 00000001 00000001 00000001"
        "008f 004d 0348 0001"
        "  0090 0045 0091 0008 0001 0bb8  0092 0015 80  0093 0010 01 00 0002 000df732 000dc65e"
        "            0148 0024 0149 0020 000003e8 00 00 00 00 00009c40 000005dc 0000186a 0000186a 00000000");

/// The set-up that follows; the reader's ids are the client's.
inline const std::vector<UhfExchange> kUhfSetup{
    {"delete all AccessSpecs", hex("0429 0000000e 00000002 00000000"),
     hex("0433 00000012 00000002 011f 0008 0000 0000")},
    {"delete all ROSpecs", hex("0415 0000000e 00000003 00000000"),
     hex("041f 00000012 00000003 011f 0008 0000 0000")},
    {"enable Impinj's extensions", hex("07ff 00000013 00000004 0000651a 15 00000000"),
     hex("07ff 00000017 00000004 0000651a 16 011f 0008 0000 0000")},
    {"a keepalive every second, exceptions and antenna events",
     hex("0403 00000026 00000005 00"
         "00f4 0012 00f5 0007 0004 80  00f5 0007 0008 80"
         "00dc 0009 01 000003e8"),
     hex("040d 00000012 00000005 011f 0008 0000 0000")},
    {"add a ROSpec: at once, antenna 1, each read by itself, with phase and RSSI",
     hex("0414 00000089 00000006"
         "00b1 007f 00000001 00 00"
         "  00b2 0012 00b3 0005 01  00b6 0009 00 00000000"
         "  00b7 002e 0001 0001  00b8 0009 00 00000000"
         "    00ba 001d 0001 01  00de 0016 0001  014a 0010 00  0150 000b 80 0004 00000000"
         "  00ed 0035 01 0001  00ee 0006 9f40"
         "    03ff 0028 0000651a 00000032"
         "      03ff 000e 0000651a 00000034 0001  03ff 000e 0000651a 00000035 0001"),
     hex("041e 00000012 00000006 011f 0008 0000 0000")},
    {"enable it", hex("0418 0000000e 00000007 00000001"), hex("0422 00000012 00000007 011f 0008 0000 0000")},
};

/// A read of 1 s after the greeting (0x00060a24182d8240): antenna 1, channel 2 of two, 1024 of 4096 steps of
/// phase, -52.5 dBm.
inline constexpr Epc kUhfTag{{0xE2, 0x00, 0x34, 0x12, 0x01, 0x23, 0x45, 0x67, 0x89, 0x00, 0xAA, 0x01}};
inline const Bytes kUhfReport =
    hex("043d 0000005b 00000002"
        "00f0 0051  8d e20034120123456789 00aa01  89 00000001  81 0001  86 cc  87 0002"
        "  82 00060a24182d8240  84 00060a24182d8240  90 00000000"
        "  03ff 000e 0000651a 00000038 0400  03ff 000e 0000651a 00000039 eb7e");

inline const UhfExchange kUhfKeepalive{"keepalive", hex("0448 0000000a 00000003"),
                                       hex("043e 0000000a 00000003")};

/// Words 2 and 3 of the user bank, which hold 1234 and 5678.
inline const std::vector<UhfExchange> kUhfReadMemory{
    {"add an AccessSpec for the tag",
     hex("0428 00000060 00000008"
         "00cf 0056 00000001 0000 01 00 00000000"
         "  00d0 0007 01 0001"
         "  00d1 003a  0152 0027 0153 0023 60 0020 0060 ffffffffffffffffffffffff"
         "                                     0060 e2003412012345678900aa01"
         "    0155 000f 0001 00000000 c0 0002 0002"
         "  00ef 0005 01"),
     hex("0432 00000012 00000008 011f 0008 0000 0000")},
    {"enable it", hex("042a 0000000e 00000009 00000001"), hex("0434 00000012 00000009 011f 0008 0000 0000")},
};
/// Told by itself at the next read of the tag, 1.25 s after the greeting; then the read itself.
inline const Bytes kUhfMemoryReport =
    hex("043d 00000068 00000003"
        "00f0 005e  8d e20034120123456789 00aa01  89 00000001  81 0001  86 cc  87 0002"
        "  82 00060a24183152d0  84 00060a24183152d0  90 00000001"
        "  015d 000d 00 0001 0002 1234 5678"
        "  03ff 000e 0000651a 00000038 0400  03ff 000e 0000651a 00000039 eb7e");

}  // namespace sensotwin::robot::transcripts
