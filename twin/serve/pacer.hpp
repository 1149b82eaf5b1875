// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/time.hpp"

namespace sensotwin::twin {

/// When the next tick of 15 ms is due by a real clock.
///
/// A factor is a promise, kept as long as this machine can: a short delay is caught up, a longer one is given
/// up and counted, so that the world never runs after lost time faster than its clients expect.
class Pacer {
 public:
  /// \param factor  simulated seconds for each real one; none: as fast as the client follows, see below
  Pacer(std::optional<double> factor, double wall_s);

  /// Real seconds until the next tick; 0 when it is due.
  ///
  /// Without a factor: real time while there is no client or while it lags, else at once, at most
  /// kFastestFactor. \param client_follows  the client has read all it was sent
  [[nodiscard]] double wait_s(double wall_s, bool client_follows) const;
  /// A tick was made.
  void tick(double wall_s);

  [[nodiscard]] bool follows_client() const { return !factor_; }
  /// Simulated seconds for each real one, over the last second or so.
  [[nodiscard]] double achieved() const { return achieved_; }
  /// Real time that was given up because it could not be caught up.
  [[nodiscard]] double given_up_s() const { return given_up_s_; }

  /// Chosen: 0.1 ms of real time from a frame to the next, in which a client has read it and answered.
  static constexpr double kFastestFactor = 150.0;

 private:
  std::optional<double> factor_;
  double due_s_;
  double last_s_;
  double given_up_s_{0.0};
  double achieved_{0.0};
  double window_begun_s_;
  long window_ticks_{0};
};

}  // namespace sensotwin::twin
