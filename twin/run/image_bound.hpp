// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/phase/estimation/path_bound.hpp"

namespace sensotwin::twin {

/// Echoes as world/radio makes them (air.hpp): each tag has so many image sources, anywhere round it.
struct ImageSources {
  int count{0};
  double amplitude{0.0};   ///< of one, relative to the direct wave
  double nearest_m{0.0};   ///< from the tag, level with it; evenly up to
  double farthest_m{0.0};  ///< this, in every direction alike
};

struct ImageBoundTask {
  robot::PathBoundTask path;  ///< a polyline; `rate_hz` rounds of all ports, every tag in each
  ImageSources images;
  int draws{10000};  ///< of images, noise and wheels: the median is known to one in a hundred
  std::uint64_t seed{1};
};

/// Error beside the path of the best estimator that is linear in the phases.
struct ImageBound {
  double rms_m{0.0};         ///< over the path and all rooms
  double run_median_m{0.0};  ///< of a run's own root mean square (the paper's eq. 4), among the draws
};

/// What the best linear estimator makes of phases that image sources bend. It knows all that can be known of
/// them but where they are: the covariance of the bends, from place to place and from antenna to antenna,
///
///     C(i, j) = n a^2 E[ (sin k l_tx(i) + sin k l_rx(i)) (sin k l_tx(j) + sin k l_rx(j)) ]
///
/// | symbol     | meaning                                                               | unit  |
/// |------------|-----------------------------------------------------------------------|-------|
/// | n, a       | images of a tag, amplitude of one                                     |       |
/// | l_tx, l_rx | how much longer the way over the image is, to transmitter and receiver | m     |
/// | k          | wave number                                                           | rad/m |
/// | E          | over the image's place, by quadrature                                 |       |
///
/// Beside it: read noise, the wheels' drift, scale and curvature, places and phases of the tags of which
/// nothing is known before. Robot and tags are linearised about the ideal way; reads up to now are used, not
/// later ones. Where posterior_bound (path_bound.hpp) takes echoes for a Gauss-Markov process, this takes
/// them for what they are to second order: an echo from the tag's own direction stays the same for metres. On
/// this way and told these wheels no linear estimator, Kalman filters among them, has less; one that solved
/// for each image's place could, and so may a robot that looks round before its first leg.
///
/// The draws are not linearised in the echoes: each has images of its own.
///
/// \pre a polyline of two legs at least, whose antennas all read in one round; images.count > 0
[[nodiscard]] ImageBound image_bound(const ImageBoundTask& task);

}  // namespace sensotwin::twin
