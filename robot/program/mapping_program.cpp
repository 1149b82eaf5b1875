// SPDX-License-Identifier: MIT
#include "robot/program/mapping_program.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "robot/program/floor_sensing.hpp"

namespace sensotwin::robot {

MappingProgram::MappingProgram(const MappingLinks& links, const MappingProgramConfig& config,
                               std::unique_ptr<Explorer> explorer)
    : config_(config),
      base_(links.base, config.base),
      floor_reader_(links.floor_reader, config.reader),
      forward_reader_(links.forward_reader, config.reader),
      sensor_board_(links.sensors),
      mode_keeper_(config.base.mode),
      mission_(config.mapping, std::move(explorer)) {}

void MappingProgram::step(Instant now) {
  base_.step(now);
  floor_reader_.step(now);
  forward_reader_.step(now);
  sensor_board_.step(now);
  take_floor_tags(floor_reader_, sensed_);
  gather_objects();
  if (base_.fresh() != nullptr) {
    state_ = *base_.fresh();
  }
  if (state_) {
    mode_keeper_.step(base_, *state_);
  }
  if (const RoombaState* state = base_.fresh()) {
    sense(*state);
    obey(mission_.step(std::exchange(sensed_, Sensed{})));
  }
}

void MappingProgram::gather_objects() {
  while (const auto event = forward_reader_.next_event()) {
    const auto* read = std::get_if<TagDataRead>(&*event);
    const auto& tag = forward_reader_.tag();
    if (read == nullptr || !tag || tag->uid != read->uid || !tag->data) {
      continue;
    }
    const auto record = decode_tag_record(*tag->data);
    if (!record || std::holds_alternative<CarpetRecord>(*record) ||
        std::find(known_objects_.begin(), known_objects_.end(), read->uid) != known_objects_.end()) {
      continue;
    }
    known_objects_.push_back(read->uid);
    objects_.push_back({read->stamp, read->uid, *record, mission_.navigator().pose()});
  }
}

void MappingProgram::sense(const RoombaState& state) {
  base_sensing_.take(state, sensor_board_, sensed_);
  take_surroundings(state, sensed_);
}

void MappingProgram::obey(const Command& command) {
  wheels_ = command.wheels;
  // Refused while the robot is not ready; it stands then, and the encoders tell the mission so.
  (void)base_.drive(command.wheels);
  if (command.write) {
    const CarpetRecord record{.map_id = config_.map_id,
                              .column = static_cast<std::int16_t>(command.write->tile.column),
                              .row = static_cast<std::int16_t>(command.write->tile.row)};
    const auto bytes = encode(record);
    if (!floor_reader_.write(command.write->tag, 0, bytes)) {
      sensed_.write_ended = TileWriteEnded{command.write->tag, false};
    }
  }
}

std::vector<ObjectSeen> MappingProgram::take_objects() {
  return std::exchange(objects_, {});
}

}  // namespace sensotwin::robot
