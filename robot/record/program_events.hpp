// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "robot/base/epc.hpp"
#include "robot/mapping/mission_log.hpp"
#include "robot/output/event_log.hpp"
#include "robot/program/hallway_program.hpp"
#include "robot/program/mapping_program.hpp"
#include "robot/program/phase_events.hpp"
#include "robot/program/phase_program.hpp"

/// What a program has to tell since it was last asked, written into events.jsonl: by the twin and by the
/// machine alike.
namespace sensotwin::robot {

/// \param seen  told of each event of the mission too
/// \throws OutputError
void record_events(MappingProgram& program, EventLog& events,
                   const std::function<void(const MissionEvent&)>& seen);
/// \throws OutputError
void record_events(HallwayProgram& program, EventLog& events,
                   const std::function<void(const HallwayEvent&)>& seen);
/// \throws OutputError
void record_events(PhaseProgram& program, EventLog& events,
                   const std::function<std::string(const Epc&)>& name_of_tag,
                   const std::function<void(const PhaseEvent&)>& seen);

}  // namespace sensotwin::robot
