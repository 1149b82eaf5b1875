// SPDX-License-Identifier: MIT
#include "twin/run/phase_recorder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "robot/record/program_events.hpp"
#include "twin/run/phase_config.hpp"
#include "twin/run/run_parts.hpp"

namespace sensotwin::twin {
namespace {

/// Ticks between two points that are drawn. Chosen: 0.105 s, 2 cm at 0.2 m/s.
constexpr int kPointEvery = 7;
/// Ticks between two looks at where the robot thinks that tags are. Chosen: 15 s; a dozen rings a run.
constexpr int kEstimateEvery = 1000;

double rms(double sum_m2, long count) {
  return count > 0 ? std::sqrt(sum_m2 / static_cast<double>(count)) : 0.0;
}

std::optional<TagLogWriter> tag_log_at(const std::optional<std::filesystem::path>& file) {
  return file ? std::optional<TagLogWriter>{std::in_place, robot::OutputFile{*file}} : std::nullopt;
}

}  // namespace

PhaseRecorder::PhaseRecorder(const Scene& scene, robot::RunFolder& folder, int trace_every, bool keep_points,
                             const std::optional<std::filesystem::path>& tag_log)
    : scene_(scene),
      path_(scene),
      destinations_(destinations_of(scene)),
      trace_(folder.stream("trace.csv"), trace_every),
      events_(folder.stream("events.jsonl")),
      tag_log_(tag_log_at(tag_log)),
      noise_(scene.world.radio->radio),
      keep_points_(keep_points) {
  result_.controller = scene.mission.phase->controller == PhaseController::kFuzzy ? "fuzzy" : "own";
}

void PhaseRecorder::record(PhaseTwin& twin) {
  record_error(twin);
  record_events(twin);
  record_row(twin);
  if (tag_log_) {
    for (const RadioReading& reading : twin.readings()) {
      tag_log_->add({robot::to_s(reading.at), reading.epc, reading.antenna, reading.channel,
                     reading.phase_rad, reading.rssi_dbm, reading.doppler_hz});
    }
  }
  if (keep_points_) {
    noise_.add(twin.heard());
    record_points(twin);
    record_estimates(twin);
  }
}

void PhaseRecorder::record_error(const PhaseTwin& twin) {
  const Vec2 p_m = twin.world().X_WR().p_m;
  if (last_m_) {
    result_.metres += (p_m - *last_m_).norm();
  }
  last_m_ = p_m;
  leg_ = twin.program().leg();
  if (leg_ > 0 && !first_reached_s_) {
    first_reached_s_ = robot::to_s(twin.now());
  }
  const std::optional<double> error_m = path_.error_m(leg_, p_m);
  if (!error_m || twin.done()) {
    return;
  }
  const bool none_yet = first_half_.count + second_half_.count == 0;
  result_.error_min_m = none_yet ? *error_m : std::min(result_.error_min_m, *error_m);
  result_.error_max_m = none_yet ? *error_m : std::max(result_.error_max_m, *error_m);
  result_.off_path_max_m = std::max(result_.off_path_max_m, path_.distance_m(p_m));
  Squares& half = 2 * leg_ <= path_.legs() - 1 ? first_half_ : second_half_;
  half.sum_m2 += *error_m * *error_m;
  ++half.count;
}

std::string PhaseRecorder::name_of(const robot::Epc& epc) const {
  const auto& tags = scene_.world.radio->tags;
  const auto found =
      std::find_if(tags.begin(), tags.end(), [&](const world::CeilingTag& tag) { return tag.epc == epc; });
  return found == tags.end() ? "" : found->name;
}

void PhaseRecorder::record_events(PhaseTwin& twin) {
  robot::record_events(
      twin.program(), events_, [this](const robot::Epc& epc) { return name_of(epc); },
      [this](const robot::PhaseEvent& event) {
        result_.tags_reached += event.name == "tag_reached" ? 1 : 0;
        result_.tags_skipped += event.name == "tag_skipped" ? 1 : 0;
      });
}

void PhaseRecorder::record_row(const PhaseTwin& twin) {
  const robot::PhaseProgram& program = twin.program();
  TraceRow row = row_of(twin);
  row.X_OR_odometry = program.odometry();
  row.X_MR_estimate = program.estimate();
  trace_.add(row);
}

void PhaseRecorder::record_points(const PhaseTwin& twin) {
  const double now_s = robot::to_s(twin.now());
  if (segments_.size() <= leg_ && leg_ < destinations_.size()) {
    segments_.push_back({now_s, "\u2192 " + scene_.world.radio->tags[destinations_[leg_]].name, leg_ > 0});
  }
  if (until_point_-- > 0) {
    return;
  }
  until_point_ = kPointEvery - 1;
  driven_.push_back({twin.world().X_WR().p_m, now_s});
  if (const auto error_m = path_.error_m(leg_, twin.world().X_WR().p_m)) {
    errors_.push_back({now_s, *error_m});
  }
}

void PhaseRecorder::record_estimates(const PhaseTwin& twin) {
  const robot::CeilingMission* mission = twin.program().ceiling();
  if (mission == nullptr || (until_estimate_-- > 0 && !twin.done())) {
    return;
  }
  until_estimate_ = kEstimateEvery - 1;
  const robot::Pose2& X_WM = scene_.robot.X_WR_start;
  const Eigen::Matrix2d turn = Eigen::Rotation2D<double>(X_WM.yaw_rad).toRotationMatrix();
  for (std::size_t i = 0; i < destinations_.size(); ++i) {
    const bool again =
        std::find(destinations_.begin(), destinations_.begin() + static_cast<std::ptrdiff_t>(i),
                  destinations_[i]) != destinations_.begin() + static_cast<std::ptrdiff_t>(i);
    const robot::TagEstimate estimate = mission->estimator().tag(mission->tag_of(i));
    if (again || estimate.knowledge < robot::TagKnowledge::kTracked) {
      continue;
    }
    estimates_.push_back({scene_.world.radio->tags[destinations_[i]].name, X_WM * estimate.p_M_m,
                          turn * estimate.covariance_m2 * turn.transpose(), robot::to_s(twin.now())});
  }
}

void PhaseRecorder::finish() {
  trace_.finish();
  events_.finish();
  if (tag_log_) {
    tag_log_->finish();
  }
}

PathResult PhaseRecorder::result(const PhaseTwin& twin) const {
  PathResult result = result_;
  result.rmse_m = rms(first_half_.sum_m2 + second_half_.sum_m2, first_half_.count + second_half_.count);
  result.rmse_first_half_m = rms(first_half_.sum_m2, first_half_.count);
  result.rmse_second_half_m = rms(second_half_.sum_m2, second_half_.count);
  result.arrived = twin.program().arrived() ? 1 : 0;
  result.minutes = robot::to_s(twin.now()) / 60.0;
  result.time_to_first_s = first_reached_s_.value_or(robot::to_s(twin.now()));
  result.end_error_m = (path_.end_m() - twin.world().X_WR().p_m).norm();
  result.wall_contacts = static_cast<int>(twin.world().contacts().wall);
  const robot::UhfReaderHealth& health = twin.program().uhf_reader().health();
  result.uhf_reads = static_cast<std::int64_t>(health.reads);
  for (const std::uint32_t count : health.faults) {
    result.uhf_faults += count;
  }
  return result;
}

}  // namespace sensotwin::twin
