// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/time.hpp"
#include "robot/drivers/roomba_state.hpp"
#include "robot/drivers/sensor_board.hpp"

namespace sensotwin::robot {

/// What every mission is told of a control step, whatever else it is told: when, how the wheels have turned
/// since the last one, the bumper, and a heading if there is a new one.
class BaseSensing {
 public:
  /// \param sensed  has stamp, counts_left, counts_right, bump_left, bump_right and compass_rad; fresh for
  /// this step
  template <class Sensed>
  void take(const RoombaState& state, const SensorBoard& board, Sensed& sensed) {
    sensed.stamp = state.stamp;
    if (state.encoders) {
      if (last_counts_) {
        sensed.counts_left = state.encoders->left - last_counts_->left;
        sensed.counts_right = state.encoders->right - last_counts_->right;
      }
      last_counts_ = state.encoders;
    }
    sensed.bump_left = state.bump_left;
    sensed.bump_right = state.bump_right;
    if (const auto& reading = board.compass(); reading && reading->stamp > compass_stamp_) {
      compass_stamp_ = reading->stamp;
      sensed.compass_rad = reading->yaw_from_north_rad;
    }
  }

 private:
  std::optional<EncoderCounts> last_counts_;
  Instant compass_stamp_;
};

}  // namespace sensotwin::robot
