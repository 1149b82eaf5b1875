// SPDX-License-Identifier: MIT
#include "robot/calibration/calibration_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/program/floor_sensing.hpp"
#include "robot/settings/program_config.hpp"

namespace sensotwin::robot {
namespace {

/// Told to move, and no wheel counts. Chosen: two seconds; a start takes a tenth.
constexpr int kStillSteps = 133;
/// Reads between two frames. Chosen: as missions hold.
constexpr std::size_t kMostReads = 8192;
/// More crossings that fit nowhere than that, and the fit is of something else.
constexpr double kMostOutliers = 0.2;

std::string say(TurnFault fault) {
  switch (fault) {
    case TurnFault::kNoCompass:
      return "the compass gave no heading while the robot stood";
    case TurnFault::kBumped:
      return "it touched something while turning: clear half a metre round it";
    case TurnFault::kLifted:
    case TurnFault::kNone:
      break;
  }
  return "a wheel hangs, or there is a hole in the floor";
}

std::string say(SquareFault fault, Tile target, double tile_m) {
  const std::string where = fmt::format("the tag {:.2f} m ahead of the first and {:.2f} m to its left",
                                        target.column * tile_m, target.row * tile_m);
  switch (fault) {
    case SquareFault::kNoFirstTag:
      return "no tag was read within a metre ahead: put the robot over a tag, facing along a row";
    case SquareFault::kTagMissing:
      return "found no tag on the way to " + where +
             ": is place.tile_m right, does the robot face along a row?";
    case SquareFault::kBumped:
      return "it touched something on the way to " + where + ": clear the square and 0.3 m round it";
    case SquareFault::kInTheWay:
      return "a virtual wall is in the way to " + where;
    case SquareFault::kLost:
      return "it lost its way to " + where + ": tags a tile apart, and nobody moving the robot?";
    case SquareFault::kTooLong:
      return "the drive took two hours: fewer laps, please";
    case SquareFault::kLifted:
    case SquareFault::kNone:
      break;
  }
  return say(TurnFault::kLifted);
}

std::string say(SpinFault fault, const std::string& tag) {
  switch (fault) {
    case SpinFault::kNotHeard:
      return "the ceiling tag '" + tag + "' was not read: is the robot under it, is its code right?";
    case SpinFault::kBumped:
      return "it touched something: clear half a metre round it and a metre ahead";
    case SpinFault::kLifted:
    case SpinFault::kNone:
      break;
  }
  return say(TurnFault::kLifted);
}

}  // namespace

CalibrationProgram::CalibrationProgram(const RobotLinks& links, const RobotSettings& settings,
                                       const CalibrationPlan& plan)
    : settings_(settings),
      plan_(plan),
      base_(links.base, base_config_of(settings.base)),
      floor_reader_(links.floor_reader, card_config_of(settings.floor_reader)),
      sensor_board_(links.sensors),
      mode_keeper_(base_config_of(settings.base).mode) {
  settings_.mission = {};
  settings_.mission.map.emplace();
  settings_.mission.map->pace.speed_mps = plan.speed_mps;
  if (plan.spins > 0) {
    uhf_reader_.emplace(links.uhf_reader, uhf_config_of(settings.uhf_reader));
  }
  begin(Stage::kTurns);
}

void CalibrationProgram::step(Instant now) {
  base_.step(now);
  floor_reader_.step(now);
  sensor_board_.step(now);
  if (uhf_reader_) {
    uhf_reader_->step(now);
    const auto reads = uhf_reader_->reads();
    if (reads_.size() + reads.size() <= kMostReads) {
      reads_.insert(reads_.end(), reads.begin(), reads.end());
    }
  }
  take_floor_tags(floor_reader_, sensed_);
  if (base_.fresh() != nullptr) {
    state_ = *base_.fresh();
  }
  if (state_) {
    mode_keeper_.step(base_, *state_);
  }
  if (const RoombaState* state = base_.fresh(); state != nullptr && base_.status() == RoombaStatus::kReady) {
    base_sensing_.take(*state, sensor_board_, sensed_);
    take_surroundings(*state, sensed_);
    think();
    sensed_ = {};
    reads_.clear();
    (void)base_.drive(wheels_);
  }
}

void CalibrationProgram::shut_down() {
  base_.shut_down();
  if (uhf_reader_) {
    uhf_reader_->shut_down();
  }
}

void CalibrationProgram::begin(Stage stage) {
  stage_ = stage;
  if (stage_ == Stage::kTurns) {
    if (plan_.turns > 0) {
      turns_.emplace(mapping_config_of(settings_).mapping.odometry, TurnPlan{.turns = plan_.turns});
      return;
    }
    stage_ = Stage::kSquare;
  }
  if (stage_ == Stage::kSquare) {
    if (plan_.laps > 0) {
      square_.emplace(mapping_config_of(settings_).mapping,
                      SquarePlan{.laps = plan_.laps, .side = plan_.side});
      return;
    }
    stage_ = Stage::kSpins;
  }
  if (stage_ == Stage::kSpins && plan_.spins > 0) {
    spins_.emplace(wheels_of(settings_.base), spin_tag().epc, SpinPlan{.turns = plan_.spins});
    return;
  }
  stage_ = Stage::kDone;
}

void CalibrationProgram::think() {
  watch_wheels();
  switch (stage_) {
    case Stage::kTurns:
      wheels_ = turns_->step(sensed_);
      if (turns_->done()) {
        end_turns();
      }
      break;
    case Stage::kSquare:
      wheels_ = square_->step(sensed_);
      if (square_->done()) {
        end_square();
      }
      break;
    case Stage::kSpins:
      // The first turn waits for a reader that is still being set up.
      if (uhf_reader_->status() == UhfReaderStatus::kReading) {
        std::stable_sort(reads_.begin(), reads_.end(),
                         [](const UhfRead& a, const UhfRead& b) { return a.at < b.at; });
        wheels_ = spins_->step(sensed_, reads_);
      }
      if (spins_->done()) {
        end_spins();
      }
      break;
    case Stage::kDone:
      wheels_ = {};
      break;
  }
}

void CalibrationProgram::watch_wheels() {
  const bool told = wheels_.left_mps != 0.0 || wheels_.right_mps != 0.0;
  const bool turned = sensed_.counts_left != 0 || sensed_.counts_right != 0;
  still_steps_ = told && !turned ? still_steps_ + 1 : 0;
  if (still_steps_ >= kStillSteps) {
    fail("the wheels were told to turn, and no count came for two seconds: are they blocked?");
  }
}

void CalibrationProgram::fail(std::string why) {
  result_.fault = std::move(why);
  wheels_ = {};
  stage_ = Stage::kDone;
}

void CalibrationProgram::end_turns() {
  if (turns_->fault() != TurnFault::kNone) {
    fail(say(turns_->fault()));
    return;
  }
  const auto [left_m, right_m] = turns_->wheel_base_m();
  result_.turned_base_m = Measured{0.5 * (left_m + right_m), 0.5 * std::abs(left_m - right_m)};
  settings_.base.wheel_base_m = result_.turned_base_m->value;
  begin(Stage::kSquare);
}

void CalibrationProgram::end_square() {
  const SquareFault fault = square_->fault();
  if (fault != SquareFault::kNone) {
    fail(say(fault, square_->target(), settings_.tile_m));
    return;
  }
  const MappingConfig config = mapping_config_of(settings_).mapping;
  const WheelPrior prior{.wheels = config.odometry,
                         .tile_m = config.tile_m,
                         .read_radius_m = config.read_radius_m,
                         .rim_sigma_m = MappingConfig{}.rim_sigma_m,
                         .tag_sigma_m = config.tag_sigma_m,
                         .notice_delay_s = config.rim_delay_s,
                         .notice_sigma_s = settings_.floor_reader.notice_sigma_s};
  result_.wheels = fit_wheels(square_->log(), prior);
  if (!result_.wheels || static_cast<double>(result_.wheels->outliers) >
                             kMostOutliers * static_cast<double>(result_.wheels->crossings)) {
    fail(
        "the tags were crossed where no wheels could have brought the robot: are robot.floor_reader and "
        "place.tile_m right?");
    return;
  }
  settings_.base.wheel_base_m = result_.wheels->wheel_base_m.value;
  settings_.base.wheel_ratio = result_.wheels->wheel_ratio.value;
  settings_.base.wheel_diameter_m =
      result_.wheels->metres_per_count.value * settings_.base.counts_per_turn / kPi;
  begin(Stage::kSpins);
}

const KnownTag& CalibrationProgram::spin_tag() const {
  const auto& tags = settings_.ceiling_tags;
  const auto named =
      std::find_if(tags.begin(), tags.end(), [&](const KnownTag& tag) { return tag.name == plan_.tag; });
  return named == tags.end() ? tags.front() : *named;
}

void CalibrationProgram::end_spins() {
  if (spins_->fault() != SpinFault::kNone) {
    fail(say(spins_->fault(), spin_tag().name));
    return;
  }
  result_.antennas = fit_antennas(spins_->reads(), {.reader = reader_model_of(settings_.uhf_reader),
                                                    .tag_height_m = spin_tag().height_m});
  if (!result_.antennas) {
    fail(
        "the phases do not agree with any place of the tag, or a port hardly heard it: are phase_sign, "
        "pi_ambiguous, path and the antennas' number and places right?");
    return;
  }
  stage_ = Stage::kDone;
}

std::string CalibrationProgram::progress() const {
  switch (stage_) {
    case Stage::kTurns:
      return "turning";
    case Stage::kSquare:
      return fmt::format("{} of {} laps", square_->laps_done(), 2 * plan_.laps);
    case Stage::kSpins:
      return fmt::format("{} reads", spins_->reads().size());
    case Stage::kDone:
      break;
  }
  return "done";
}

}  // namespace sensotwin::robot
