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

}  // namespace sensotwin::world
