// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_ro_spec.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

namespace sensotwin::twin {
namespace llrp = robot::llrp;
using llrp::RoSpecState;
using llrp::StatusCode;
namespace {

using std::chrono::milliseconds;

/// One inventory round of one antenna (data study, 3.8).
constexpr milliseconds kRound{14};
constexpr std::uint8_t kMaxPriority = 7;

[[nodiscard]] llrp::LlrpStatus check_ai_spec(const llrp::AiSpec& spec, const UhfReaderSettings& settings) {
  if (spec.antennas.empty()) {
    return refused_field_in(llrp::AiSpec::kType, 1, StatusCode::kInvalidField);
  }
  for (const std::uint16_t antenna : spec.antennas) {
    if (antenna > settings.antennas) {
      return refused_field_in(llrp::AiSpec::kType, 2, StatusCode::kFieldOutOfRange);
    }
  }
  if (spec.inventory.size() > 1) {
    return refused(llrp::InventoryParameterSpec::kType, StatusCode::kInOverflowParameter);
  }
  const llrp::InventoryParameterSpec& inventory = spec.inventory.front();
  if (inventory.id == 0 || inventory.protocol != 1) {
    return refused_field_in(llrp::InventoryParameterSpec::kType, inventory.id == 0 ? 1 : 2,
                            StatusCode::kInvalidField);
  }
  for (const llrp::AntennaConfiguration& antenna : inventory.antennas) {
    if (antenna.antenna > settings.antennas) {
      return refused_field_in(llrp::AntennaConfiguration::kType, 1, StatusCode::kFieldOutOfRange);
    }
  }
  return {};
}

}  // namespace

llrp::LlrpStatus refused(std::uint16_t parameter, StatusCode code) {
  return {.code = StatusCode::kParameterError,
          .parameter_error = llrp::ParameterError{parameter, code, {}, {}}};
}
llrp::LlrpStatus refused_field(std::uint16_t field, StatusCode code) {
  return {.code = StatusCode::kFieldError, .field_error = llrp::FieldError{field, code}};
}
llrp::LlrpStatus refused_field_in(std::uint16_t parameter, std::uint16_t field, StatusCode code) {
  return {.code = StatusCode::kParameterError,
          .parameter_error =
              llrp::ParameterError{parameter, StatusCode::kInFieldError, llrp::FieldError{field, code}, {}}};
}

llrp::LlrpStatus RoSpecRunner::add(const llrp::RoSpec& spec) {
  if (settings_.refuse_ro_specs) {
    return {.code = StatusCode::kDeviceError, .description = "out of order"};
  }
  if (spec.id == 0 || (spec_ && spec_->id == spec.id)) {
    return refused_field_in(llrp::RoSpec::kType, 1, StatusCode::kInvalidField);
  }
  if (spec_) {
    return refused(llrp::RoSpec::kType, StatusCode::kInOverflowParameter);
  }
  if (spec.priority > kMaxPriority) {
    return refused_field_in(llrp::RoSpec::kType, 2, StatusCode::kFieldOutOfRange);
  }
  if (spec.state != RoSpecState::kDisabled) {
    return refused_field_in(llrp::RoSpec::kType, 3, StatusCode::kInvalidField);
  }
  for (const llrp::AiSpec& ai_spec : spec.ai_specs) {
    if (auto status = check_ai_spec(ai_spec, settings_); !status.ok()) {
      return status;
    }
  }
  spec_ = spec;
  return {};
}

llrp::LlrpStatus RoSpecRunner::remove(std::uint32_t id) {
  if (id != 0 && !names(id)) {
    return refused_field(1, StatusCode::kInvalidField);
  }
  static_cast<void>(disable(id));
  spec_.reset();
  return {};
}

llrp::LlrpStatus RoSpecRunner::enable(std::uint32_t id, robot::Instant now) {
  if (id != 0 && !names(id)) {
    return refused_field(1, StatusCode::kInvalidField);
  }
  if (spec_ && spec_->state == RoSpecState::kDisabled) {
    spec_->state = RoSpecState::kInactive;
    const llrp::RoSpecStartTrigger& trigger = spec_->boundary.start;
    next_start_.reset();
    if (trigger.kind == llrp::RoStart::kImmediate) {
      next_start_ = now;
    } else if (trigger.kind == llrp::RoStart::kPeriodic && trigger.periodic) {
      next_start_ = now + milliseconds{trigger.periodic->offset_ms};
    }
  }
  return {};
}

llrp::LlrpStatus RoSpecRunner::disable(std::uint32_t id) {
  if (id != 0 && !names(id)) {
    return refused_field(1, StatusCode::kInvalidField);
  }
  if (is_active()) {
    end(begun_, false);
  }
  if (spec_) {
    spec_->state = RoSpecState::kDisabled;
  }
  next_start_.reset();
  return {};
}

llrp::LlrpStatus RoSpecRunner::start(std::uint32_t id, robot::Instant now) {
  if (id == 0 || !names(id) || spec_->state == RoSpecState::kDisabled) {
    return refused_field(1, StatusCode::kInvalidField);
  }
  if (!is_active()) {
    begin(now);
  }
  return {};
}

llrp::LlrpStatus RoSpecRunner::stop(std::uint32_t id) {
  if (id == 0 || !names(id)) {
    return refused_field(1, StatusCode::kInvalidField);
  }
  if (is_active()) {
    end(begun_, false);
  }
  next_start_.reset();
  return {};
}

bool RoSpecRunner::is_active() const {
  return spec_ && spec_->state == RoSpecState::kActive;
}

bool RoSpecRunner::reads(std::uint16_t antenna) const {
  return is_active() && std::ranges::find(antennas_, antenna) != antennas_.end();
}

ReadingContext RoSpecRunner::context() const {
  assert(is_active());
  return {spec_->id, static_cast<std::uint16_t>(index_ + 1), spec_->ai_specs[index_].inventory.front().id};
}

void RoSpecRunner::begin(robot::Instant at) {
  spec_->state = RoSpecState::kActive;
  next_start_.reset();
  begun_ = at;
  index_ = 0;
  listener_.ro_spec_started(spec_->id);
  begin_ai_spec(at);
}

void RoSpecRunner::begin_ai_spec(robot::Instant at) {
  ai_begun_ = last_new_tag_ = at;
  observations_ = 0;
  seen_.clear();
  antennas_ = spec_->ai_specs[index_].antennas;
  if (std::ranges::find(antennas_, 0) != antennas_.end()) {
    antennas_.clear();
    for (std::uint16_t antenna = 1; antenna <= settings_.antennas; ++antenna) {
      antennas_.push_back(antenna);
    }
  }
}

void RoSpecRunner::end_ai_spec(robot::Instant at) {
  listener_.ai_spec_ended(spec_->id, static_cast<std::uint16_t>(index_ + 1));
  if (index_ + 1 < spec_->ai_specs.size()) {
    ++index_;
    begin_ai_spec(at);
  } else {
    antennas_.clear();
    end(at, true);
  }
}

void RoSpecRunner::end(robot::Instant at, bool by_itself) {
  if (!antennas_.empty()) {
    listener_.ai_spec_ended(spec_->id, static_cast<std::uint16_t>(index_ + 1));
  }
  antennas_.clear();
  spec_->state = RoSpecState::kInactive;
  listener_.ro_spec_ended(spec_->id);
  const llrp::RoSpecStartTrigger& trigger = spec_->boundary.start;
  if (by_itself && trigger.kind == llrp::RoStart::kImmediate) {
    next_start_ = at;
  } else if (trigger.kind == llrp::RoStart::kPeriodic && trigger.periodic &&
             trigger.periodic->period_ms > 0) {
    next_start_ = begun_ + milliseconds{trigger.periodic->period_ms};
  }
}

std::optional<robot::Instant> RoSpecRunner::ai_spec_due() const {
  const llrp::AiSpecStopTrigger& stop = spec_->ai_specs[index_].stop;
  if (stop.kind == llrp::AiStop::kDuration) {
    return ai_begun_ + milliseconds{stop.duration_ms};
  }
  if (stop.kind != llrp::AiStop::kTagObservation || !stop.tags) {
    return std::nullopt;
  }
  const llrp::TagObservationTrigger& tags = *stop.tags;
  std::optional<robot::Instant> due;
  if (tags.kind == llrp::TagObservation::kNoNewTags) {
    due = last_new_tag_ + milliseconds{tags.idle_ms};
  } else if (tags.kind == llrp::TagObservation::kAttempts) {
    due = ai_begun_ + kRound * tags.attempts * static_cast<int>(antennas_.size());
  }
  if (tags.timeout_ms > 0) {
    const robot::Instant out = ai_begun_ + milliseconds{tags.timeout_ms};
    due = due ? std::min(*due, out) : out;
  }
  return due;
}

std::optional<robot::Instant> RoSpecRunner::ro_spec_due() const {
  const llrp::RoSpecStopTrigger& stop = spec_->boundary.stop;
  return stop.kind == llrp::RoStop::kDuration
             ? std::optional<robot::Instant>{begun_ + milliseconds{stop.duration_ms}}
             : std::nullopt;
}

void RoSpecRunner::step(robot::Instant now) {
  if (!spec_) {
    return;
  }
  // Triggers of no length would start and end for ever at one instant: each step allows so many changes.
  std::size_t changes = 2 * spec_->ai_specs.size() + 2;
  while (changes-- > 0) {
    if (spec_->state == RoSpecState::kInactive && next_start_ && *next_start_ <= now) {
      begin(*next_start_);
      continue;
    }
    if (!is_active()) {
      return;
    }
    const auto ro_due = ro_spec_due();
    const auto ai_due = ai_spec_due();
    if (ro_due && *ro_due <= now && (!ai_due || *ro_due <= *ai_due)) {
      end(*ro_due, true);
    } else if (ai_due && *ai_due <= now) {
      end_ai_spec(*ai_due);
    } else {
      return;
    }
  }
}

void RoSpecRunner::observe(const RadioReading& reading) {
  assert(reads(reading.antenna));
  const llrp::AiSpecStopTrigger& stop = spec_->ai_specs[index_].stop;
  if (stop.kind != llrp::AiStop::kTagObservation || !stop.tags) {
    return;
  }
  ++observations_;
  if (stop.tags->kind == llrp::TagObservation::kNoNewTags && seen_.insert(reading.epc).second) {
    last_new_tag_ = reading.at;
  }
  if (stop.tags->kind == llrp::TagObservation::kCount && observations_ >= stop.tags->tags) {
    end_ai_spec(reading.at);
  }
}

}  // namespace sensotwin::twin
