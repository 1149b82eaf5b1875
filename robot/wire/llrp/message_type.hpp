// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sensotwin::robot::llrp {

/// LLRP 1.0.1, table 4. A response is its request + 10, but for CLOSE_CONNECTION.
enum class MessageType : std::uint16_t {
  kGetReaderCapabilities = 1,
  kGetReaderConfig = 2,
  kSetReaderConfig = 3,
  kCloseConnectionResponse = 4,
  kGetReaderCapabilitiesResponse = 11,
  kGetReaderConfigResponse = 12,
  kSetReaderConfigResponse = 13,
  kCloseConnection = 14,
  kAddRoSpec = 20,
  kDeleteRoSpec = 21,
  kStartRoSpec = 22,
  kStopRoSpec = 23,
  kEnableRoSpec = 24,
  kDisableRoSpec = 25,
  kGetRoSpecs = 26,
  kAddRoSpecResponse = 30,
  kDeleteRoSpecResponse = 31,
  kStartRoSpecResponse = 32,
  kStopRoSpecResponse = 33,
  kEnableRoSpecResponse = 34,
  kDisableRoSpecResponse = 35,
  kGetRoSpecsResponse = 36,
  kAddAccessSpec = 40,
  kDeleteAccessSpec = 41,
  kEnableAccessSpec = 42,
  kDisableAccessSpec = 43,
  kGetAccessSpecs = 44,
  kAddAccessSpecResponse = 50,
  kDeleteAccessSpecResponse = 51,
  kEnableAccessSpecResponse = 52,
  kDisableAccessSpecResponse = 53,
  kGetAccessSpecsResponse = 54,
  kGetReport = 60,
  kRoAccessReport = 61,
  kKeepalive = 62,
  kReaderEventNotification = 63,
  kEnableEventsAndReports = 64,
  kKeepaliveAck = 72,
  kErrorMessage = 100,
  kCustomMessage = 1023,
};

}  // namespace sensotwin::robot::llrp
