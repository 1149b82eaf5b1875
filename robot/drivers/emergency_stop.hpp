// SPDX-License-Identifier: MIT
#pragma once

#include "robot/base/bytes.hpp"

namespace sensotwin::robot {

/// What makes a Roomba's wheels stand whatever was being said to it, Open Interface and SCI alike.
///
/// The robot waits without limit for the data of a command that was begun (protocols study, 1.2), so a stop
/// behind a torn command would be eaten as its data. As many zeros as the longest command of the driver lacks
/// come first: they complete a torn Drive with speeds that the next command takes back within a millisecond,
/// and where nothing was torn each is an unknown opcode, which the robot skips. Then Drive Direct 0 0, which
/// a Roomba 400 skips, and Drive 0 0.
[[nodiscard]] Bytes emergency_stop();

/// After it: Start, which leaves safe and full mode and so stops every motor again, and Stop, which ends the
/// Open Interface and its stream. Like Roomba::shut_down(), for a driver that cannot speak any more.
[[nodiscard]] Bytes emergency_farewell();

}  // namespace sensotwin::robot
