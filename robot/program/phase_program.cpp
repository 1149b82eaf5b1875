// SPDX-License-Identifier: MIT
#include "robot/program/phase_program.hpp"

#include <algorithm>
#include <utility>

#include "robot/wire/tag_record.hpp"

namespace sensotwin::robot {
namespace {

/// The EPC that a floor tag holds; nothing when it is blank, short, or a tile of somebody's carpet.
std::optional<Epc> epc_in(const std::optional<Bytes>& data) {
  Epc epc;
  if (!data || data->size() < epc.bytes.size()) {
    return std::nullopt;
  }
  const auto record = decode_tag_record(*data);
  if (record && std::holds_alternative<CarpetRecord>(*record)) {
    return std::nullopt;
  }
  std::copy_n(data->begin(), epc.bytes.size(), epc.bytes.begin());
  return epc == Epc{} ? std::nullopt : std::optional{epc};
}

}  // namespace

PhaseProgram::PhaseProgram(const PhaseLinks& links, const PhaseProgramConfig& config)
    : base_(links.base, config.base),
      uhf_reader_(links.uhf_reader, config.uhf_reader),
      floor_reader_(links.floor_reader, config.floor_reader),
      sensor_board_(links.sensors),
      mode_keeper_(config.base.mode),
      wheel_model_(config.wheels) {
  if (const auto* fuzzy = std::get_if<FuzzyMissionConfig>(&config.mission)) {
    fuzzy_.emplace(*fuzzy);
  } else {
    ceiling_.emplace(std::get<CeilingMissionConfig>(config.mission));
  }
}

void PhaseProgram::step(Instant now) {
  base_.step(now);
  uhf_reader_.step(now);
  floor_reader_.step(now);
  sensor_board_.step(now);
  gather_reads();
  gather_floor_tags();
  if (const RoombaState* state = base_.fresh()) {
    state_ = *state;
  }
  if (state_) {
    mode_keeper_.step(base_, *state_);
  }
  if (const RoombaState* state = base_.fresh()) {
    sense(*state);
    wheels_ = think().wheels;
    sensed_ = {};
    reads_.clear();
    // Refused while the robot is not ready; it stands then, and the encoders tell the mission so.
    (void)base_.drive(wheels_);
  }
}

void PhaseProgram::shut_down() {
  base_.shut_down();
  uhf_reader_.shut_down();
}

void PhaseProgram::gather_reads() {
  // A robot without frames has no mission step; its reads would be old by then. Chosen: four rounds of a
  // thousand tags by two antennas.
  constexpr std::size_t kMostReads = 8192;
  const auto reads = uhf_reader_.reads();
  if (reads_.size() + reads.size() <= kMostReads) {
    reads_.insert(reads_.end(), reads.begin(), reads.end());
  }
}

void PhaseProgram::gather_floor_tags() {
  while (const auto event = floor_reader_.next_event()) {
    if (const auto* read = std::get_if<TagDataRead>(&*event)) {
      const auto& tag = floor_reader_.tag();
      if (tag && tag->uid == read->uid) {
        if (const std::optional<Epc> epc = epc_in(tag->data)) {
          sensed_.floor_tag = epc;
        }
      }
    } else if (std::holds_alternative<TagLeft>(*event)) {
      sensed_.floor_tag_left = true;
    }
  }
}

void PhaseProgram::sense(const RoombaState& state) {
  base_sensing_.take(state, sensor_board_, sensed_);
  X_OR_ = advanced(X_OR_, wheel_step(wheel_model_, sensed_.counts_left, sensed_.counts_right));
  sensed_.reader_up = uhf_reader_.status() == UhfReaderStatus::kReading;
  // A reader may report a read after a later one (uhf_reader.hpp).
  std::stable_sort(reads_.begin(), reads_.end(),
                   [](const UhfRead& a, const UhfRead& b) { return a.at < b.at; });
  sensed_.reads = reads_;
}

PhaseCommand PhaseProgram::think() {
  return fuzzy_ ? fuzzy_->step(sensed_) : ceiling_->step(sensed_);
}

bool PhaseProgram::done() const {
  return fuzzy_ ? fuzzy_->done() : ceiling_->done();
}

bool PhaseProgram::arrived() const {
  return fuzzy_ ? fuzzy_->arrived() : ceiling_->arrived();
}

std::size_t PhaseProgram::leg() const {
  return fuzzy_ ? fuzzy_->status().destination : ceiling_->leg();
}

std::vector<PhaseEvent> PhaseProgram::take_events() {
  std::vector<PhaseEvent> events;
  if (fuzzy_) {
    for (const FuzzyEvent& event : fuzzy_->log().take()) {
      events.push_back(event_of(event));
    }
  } else {
    for (const CeilingEvent& event : ceiling_->events()) {
      events.push_back(event_of(event));
    }
    ceiling_->forget_events();
  }
  return events;
}

std::optional<Pose2> PhaseProgram::estimate() const {
  return ceiling_ ? std::optional{ceiling_->status().X_MR} : std::nullopt;
}

}  // namespace sensotwin::robot
