// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "robot/base/random.hpp"
#include "world/radio_description.hpp"

namespace sensotwin::world {

/// Profile `paper`: two receivers at once, one frequency, Gaussian phase noise proportional to distance,
/// nothing else (Gueaieb & Miah, section IV; numbers: algorithms study, A.0). The defaults of
/// RadioDescription, which says where each comes from.
[[nodiscard]] RadioDescription paper_radio();

/// Profile `impinj_r420`: what logs of a Speedway R420 show (data study, sections 3 and 4).
/// \param random    shuffles the hop table, each reader having its own (3.1)
/// \param antennas  ports in use, one after another; see measured_slots_s()
[[nodiscard]] RadioDescription impinj_r420_radio(robot::RandomStream random, std::size_t antennas);

/// Slots of an R420 with so many ports in use (data study, 3.8): 14.02 ms with one port; 28.9, 29.3, 31.0,
/// 14.0 ms with four. In between, and beyond, as chosen: the measured slots repeated, the last port having
/// the short one. \pre antennas > 0
[[nodiscard]] std::vector<double> measured_slots_s(std::size_t antennas);

/// Left and right of the middle, 0.16 m apart (algorithms study, A.0), looking straight up.
[[nodiscard]] std::vector<AntennaDescription> pair_of_antennas();

/// Four patches like the S9025 of the data study (5.5 dBic; 0.13 m square by its name) on a ridge roof across
/// the robot: ports 1 and 2 on the side that looks ahead, left and right; 3 and 4 on the side that looks
/// behind. Boresights 40 degrees above the horizon, so that under a ceiling of 3 m a tag 8 m off (20 degrees
/// high) and one overhead lose about the same. Just within the robot's outline, 0.21 m high.
[[nodiscard]] std::vector<AntennaDescription> roof_of_antennas();

}  // namespace sensotwin::world
