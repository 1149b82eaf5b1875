// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "robot/base/geometry.hpp"

/// Phases of the signal of a tag, and which sign they have.
///
/// The paper contradicts itself (Gueaieb & Miah 2008, section IV.B): "the phase difference of the signal is
/// positive when the transmitting transponder is on the left side of the reader" before its rules, "if the
/// RFID tag is on the left/right of the reader, where dphi is negative and positive, respectively" after
/// them. What follows from its other statements:
///
///     baseband lag over a path of length d:  I + jQ = A exp(-j k d),   k = 2 pi / lambda
///     equation 1, all four quadrants:        phi = atan2(I, Q) = k d + pi/2        -> grows with distance
///     antenna 1 left, antenna 2 right, tag on the left: d_1 < d_2
///     equation 2:                            dphi = phi_1 - phi_2 < 0
///     rule "if dphi is Neg then CCW":        turns left, towards the tag
///
/// So equation 1, the rules and the sentence after them agree when antenna 1 is the left one; the sentence
/// before them is wrong. For a tag at horizontal distance rho, bearing beta from the nose (left positive),
/// slant range d, antennas b apart (algorithms study, A.0):
///
///     dphi = -k b (rho / d) sin(beta)        (one leg differs, as with the paper's separate transmitter)
///
/// It vanishes under the tag, and is the same for beta and pi - beta. With the sign turned, no run of a
/// hundred arrives (FuzzyStudy in the tests).
namespace sensotwin::robot {

/// Equation 1 of the paper over all four quadrants; in (-pi, pi]. \pre not both zero
[[nodiscard]] inline double phase_from_iq(double in_phase, double quadrature) {
  return std::atan2(in_phase, quadrature);
}

/// Equation 2 of the paper, in (-pi, pi]: negative with the tag on the left of a reader whose phase grows
/// with distance.
[[nodiscard]] inline double phase_difference(double left_rad, double right_rad) {
  return wrap_angle(left_rad - right_rad);
}

/// The same of a reader that tells each phase up to pi only; in (-pi/2, pi/2].
[[nodiscard]] inline double phase_difference_modulo_pi(double left_rad, double right_rad) {
  return wrap_angle(2.0 * (left_rad - right_rad)) / 2.0;
}

/// Longest distance of two antennas at which every direction of a tag has a phase difference of its own.
///
///     legs k b < pi,  or pi/2 when phases are known up to pi only
///
/// \param legs  1 where only reception differs between the antennas, 2 where each one also transmits
[[nodiscard]] inline double widest_spacing_m(double wavelength_m, int legs, bool pi_ambiguous) {
  return wavelength_m / (2.0 * legs * (pi_ambiguous ? 2.0 : 1.0));
}

}  // namespace sensotwin::robot
