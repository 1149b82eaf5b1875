// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/phase/estimation/ceiling_estimator.hpp"
#include "robot/phase/estimation/line_follower.hpp"
#include "robot/phase/estimation/tag_path.hpp"

namespace sensotwin::robot {

/// What to do about a tag that is not heard, or a list that seems out of order.
enum class OnTagFault : std::uint8_t {
  kSearch,  ///< look round and round about, then skip. Of an order: say so and go on as listed
  kSkip,    ///< say so and go on to the next. Of an order: say so and exchange the two
  kStop,    ///< say so and stop for good
};

/// How faults are noticed and what is done then.
struct FaultPolicy {
  OnTagFault on_missing{OnTagFault::kSkip};
  /// A destination not heard for so long is missing. Chosen: half a hop sequence of the R420 (data study,
  /// 3.8), after which some channel would have got through.
  double missing_after_s{5.0};
  /// The next tag but one is nearer than the next by this factor: the list is doubted. Zero: never looked at.
  double order_factor{0.0};
  OnTagFault on_order{OnTagFault::kSkip};
  double silent_after_s{0.5};  ///< no read of any tag: the reader is silent. Chosen: ten rounds of 20 Hz
  double blind_way_m{1.0};     ///< driven on by the wheels alone. Chosen: the wheels then are 2 cm off
  double give_up_s{60.0};      ///< of waiting for a silent reader
  double back_off_m{0.06};     ///< after a bump
  int most_bumps{3};           ///< on one leg; then it stops for good
  /// The robot's middle is kept this near the path, as far as it knows: stops for good when it is off by
  /// more, waits where it does not know.
  std::optional<double> corridor_half_width_m;
};

struct CeilingMissionConfig {
  EstimatorConfig estimator;
  FollowerConfig follower;
  /// In the order in which they are to be passed; a tag may come again. A circle about a tag: that tag.
  std::vector<ListedTag> route;
  TagPathKind path{TagPathKind::kPolyline};
  bool circle_left{true};       ///< counter-clockwise
  double circle_radius_m{2.0};  ///< kCircleAbout
  double circle_laps{1.0};      ///< kCircleAbout
  int tags_ahead{2};   ///< of the destination, sought and used. Chosen: what a smooth curve needs, and one
  int tags_behind{2};  ///< of the last one passed
  FaultPolicy faults;
};

enum class CeilingEventKind : std::uint8_t {
  kTagFound,    ///< tag's place known
  kTagReached,  ///< by the estimate
  kTagMissing,  ///< the destination is not heard
  kTagSilent,   ///< known, but not heard now (shadowed): driven to by its estimate
  kTagSkipped,
  kTagLost,        ///< its reads do not fit its place any more
  kTagMoved,       ///< found again elsewhere: value is the distance in metres
  kOrderDoubtful,  ///< two tags of the list seem exchanged (EPCs swapped)
  kOrderExchanged,
  kReaderSilent,
  kReaderBack,  ///< value: seconds of silence
  kCablesSwapped,
  kCablesDoubted,
  kBump,
  kSearching,
  kOffPath,  ///< further from the path than the corridor allows, or not known well enough
  kStopped,  ///< for good, not arrived
  kArrived,  ///< at the last tag
};

struct CeilingEvent {
  Instant stamp;
  CeilingEventKind kind{CeilingEventKind::kTagFound};
  int leg{0};
  std::optional<Epc> tag;
  double value{0.0};
};

/// A sentence for the log, without full stop.
[[nodiscard]] const char* say(CeilingEventKind kind);

enum class CeilingMode : std::uint8_t {
  kDriving,
  kTurning,
  kLooking,  ///< turns on the spot until the destination's place shows
  kBackingOff,
  kSearching,
  kWaiting,
  kFinished,
};

/// For traces and pictures. Frame M.
struct CeilingStatus {
  Pose2 X_MR;
  Eigen::Matrix3d pose_covariance{Eigen::Matrix3d::Zero()};
  std::size_t leg{0};
  CeilingMode mode{CeilingMode::kDriving};
  std::optional<PathReference> path;  ///< none while the destination's place is not known
  double across_sigma_m{0.0};         ///< one sigma of path->across_m
};

}  // namespace sensotwin::robot
