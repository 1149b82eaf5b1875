// SPDX-License-Identifier: MIT
#include "robot/drivers/emergency_stop.hpp"

#include "robot/drivers/roomba_state.hpp"
#include "robot/wire/oi_commands.hpp"

namespace sensotwin::robot {
namespace {

void append(Bytes& to, const oi::Command& command) {
  const Bytes bytes = oi::encode(command);
  to.insert(to.end(), bytes.begin(), bytes.end());
}

}  // namespace

Bytes emergency_stop() {
  // The stream request is the driver's longest command: opcode, number, packet ids.
  Bytes bytes(kStreamedPackets.size() + 1, 0);
  append(bytes, oi::DriveDirect{});
  append(bytes, oi::Drive{});
  return bytes;
}

Bytes emergency_farewell() {
  Bytes bytes;
  append(bytes, oi::Start{});
  append(bytes, oi::Stop{});
  return bytes;
}

}  // namespace sensotwin::robot
