// SPDX-License-Identifier: MIT
#include "world/radio/air.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <string>

namespace sensotwin::world {
namespace {

constexpr double kLight_mps = 299'792'458.0;
/// Chosen: side and back lobes of a patch, as data sheets of such antennas promise (front to back 20 dB).
constexpr double kPatternFloor_db = 20.0;
/// Nearer than this the law of distance has no meaning. Chosen: far below any antenna's size.
constexpr double kNearest_m = 0.01;
/// A read's own scatter that luck may lift: chosen, one in 10^9.
constexpr double kLuck = 6.0;
/// A WaveField is bounded by so many sigma.
constexpr double kFieldBound = 4.0;

/// n of cos^n that is one half at half the beam's width.
double exponent_of(double beam_width_rad) {
  return std::log(0.5) / std::log(std::cos(0.5 * beam_width_rad));
}

Eigen::Vector3d turned(const Eigen::Vector3d& v, const robot::Vec2& direction) {
  return {direction.x() * v.x() - direction.y() * v.y(), direction.y() * v.x() + direction.x() * v.y(),
          v.z()};
}

}  // namespace

robot::RandomStream stream_of(const CeilingTag& tag, const robot::RandomStream& radio) {
  const robot::RandomStream tags = radio.fork("tag");
  if (!tag.name.empty()) {
    return tags.fork(tag.name);
  }
  const std::string bytes(tag.epc.bytes.begin(), tag.epc.bytes.end());
  return tags.fork("epc").fork(bytes);
}

Air::Air(const RadioWorld& world, const robot::RandomStream& radio_random)
    : radio_(world.radio),
      described_(world.antennas),
      hopeless_dbm_(world.radio.cutoff_dbm - kLuck * world.radio.rssi_sigma_db),
      aerials_(world.antennas.size()) {
  const auto& channels_hz = radio_.channels_hz;
  assert(!channels_hz.empty());
  band_middle_hz_ =
      std::accumulate(channels_hz.begin(), channels_hz.end(), 0.0) / static_cast<double>(channels_hz.size());
  for (std::size_t a = 0; a < described_.size(); ++a) {
    aerials_[a].over_reference_db = described_[a].gain_dbi - kReferenceGain_dbi;
    aerials_[a].pattern_exponent = exponent_of(described_[a].beam_width_rad);
    aerials_[a].least_cosine = std::pow(10.0, -0.1 * kPatternFloor_db / aerials_[a].pattern_exponent);
  }
  const bool smooth =
      radio_.place_sigma_rad != 0.0 || radio_.place_sigma_db != 0.0 || radio_.channel_sigma_db != 0.0;
  for (const CeilingTag& tag : world.tags) {
    tags_.push_back({.p_W_m = {tag.at_m.x(), tag.at_m.y(), tag.height_m},
                     .loss_db = 2.0 * tag.shadow_db,
                     .present = tag.present});
    const robot::RandomStream own = stream_of(tag, radio_random);
    add_images(tags_.back(), own.fork("images"));
    if (smooth) {
      add_fields(own);
    }
  }
}

void Air::add_images(const Ceiling& tag, robot::RandomStream random) {
  for (int i = 0; i < radio_.images; ++i) {
    const double away_m = 2.0 * random.uniform(0.5 * kNearestImage_m, 0.5 * kFarthestImage_m);
    const double yaw_rad = random.uniform(0.0, 2.0 * robot::kPi);
    images_W_m_.emplace_back(tag.p_W_m + away_m * Eigen::Vector3d{std::cos(yaw_rad), std::sin(yaw_rad), 0.0});
  }
}

void Air::add_fields(const robot::RandomStream& random) {
  for (std::size_t a = 0; a < described_.size(); ++a) {
    const robot::RandomStream own = random.fork("antenna " + std::to_string(a));
    fields_.push_back(
        {.phase_rad = WaveField({.sigma = radio_.place_sigma_rad,
                                 .length_m = radio_.place_length_m,
                                 .delay_s = radio_.place_delay_s},
                                own.fork("phase of the place")),
         .place_db = WaveField({.sigma = radio_.place_sigma_db, .length_m = radio_.place_length_m},
                               own.fork("fading of the place")),
         .channel_db = WaveField({.sigma = radio_.channel_sigma_db,
                                  .length_m = radio_.place_length_m,
                                  .delay_s = radio_.channel_delay_s},
                                 own.fork("fading of the channel"))});
  }
}

void Air::place(const robot::Pose2& X_WR) {
  const robot::Vec2 direction = X_WR.direction();
  const Eigen::Vector3d p_WR_W{X_WR.p_m.x(), X_WR.p_m.y(), 0.0};
  for (std::size_t a = 0; a < aerials_.size(); ++a) {
    aerials_[a].p_W_m = p_WR_W + turned(described_[a].at_m, direction);
    aerials_[a].boresight_W = turned(described_[a].boresight, direction);
  }
  transmitter_W_m_ = p_WR_W;
  transmitter_W_m_.z() = described_.empty() ? 0.0 : described_.front().at_m.z();
}

std::complex<double> Air::echo_gain(std::uint32_t tag, const Eigen::Vector3d& from_W_m, double d_m,
                                    double k_radpm) const {
  std::complex<double> gain{1.0, 0.0};
  const auto count = static_cast<std::size_t>(radio_.images);
  for (std::size_t i = 0; i < count; ++i) {
    const double later_m = (images_W_m_[tag * count + i] - from_W_m).norm() - d_m;
    gain += std::polar(radio_.image_amplitude, -k_radpm * later_m);
  }
  return gain;
}

std::optional<Air::Heard> Air::hear(std::uint32_t tag, std::uint16_t antenna, std::uint16_t channel) const {
  const Ceiling& ceiling = tags_[tag];
  if (!ceiling.present) {
    return std::nullopt;
  }
  const Aerial& aerial = aerials_[antenna];
  const Eigen::Vector3d way_m = ceiling.p_W_m - aerial.p_W_m;
  const double d_m = std::max(way_m.norm(), kNearest_m);
  const double cosine = aerial.boresight_W.dot(way_m) / d_m;
  double out_m = d_m;
  double out_cosine = cosine;
  if (radio_.path == PathKind::kBistatic) {
    const Eigen::Vector3d out = ceiling.p_W_m - transmitter_W_m_;
    out_m = std::max(out.norm(), kNearest_m);
    out_cosine = out.z() / out_m;
  }
  // The pattern's floor is laid under the cosines, so that one logarithm serves both ways.
  const double pattern_db =
      10.0 * aerial.pattern_exponent *
      std::log10(std::max(cosine, aerial.least_cosine) * std::max(out_cosine, aerial.least_cosine));
  Heard heard{.distance_m = d_m, .path_m = out_m + d_m};
  heard.rssi_dbm = radio_.rssi_at_1m_dbm + 0.5 * radio_.rssi_slope_db * std::log10(out_m * d_m) +
                   2.0 * aerial.over_reference_db + pattern_db - ceiling.loss_db;
  const double k_radpm = 2.0 * robot::kPi * radio_.channels_hz[channel] / kLight_mps;
  if (radio_.images > 0) {
    const std::complex<double> back = echo_gain(tag, aerial.p_W_m, d_m, k_radpm);
    const std::complex<double> both =
        back * (radio_.path == PathKind::kBistatic ? echo_gain(tag, transmitter_W_m_, out_m, k_radpm) : back);
    heard.rssi_dbm += 10.0 * std::log10(std::norm(both));
    heard.echo_rad = -std::arg(both);
  }
  if (fields_.empty()) {
    return heard.rssi_dbm < hopeless_dbm_ ? std::nullopt : std::optional{heard};
  }
  const double best_dbm = heard.rssi_dbm + kFieldBound * (radio_.place_sigma_db + radio_.channel_sigma_db);
  if (best_dbm < hopeless_dbm_) {
    return std::nullopt;
  }
  const Fields& fields = fields_[tag * aerials_.size() + antenna];
  const robot::Vec2 at_m = aerial.p_W_m.head<2>();
  const double from_middle_hz = radio_.channels_hz[channel] - band_middle_hz_;
  heard.rssi_dbm += fields.place_db.at(at_m, 0.0) + fields.channel_db.at(at_m, from_middle_hz);
  if (heard.rssi_dbm < hopeless_dbm_) {
    return std::nullopt;
  }
  heard.echo_rad += fields.phase_rad.at(at_m, from_middle_hz);
  return heard;
}

}  // namespace sensotwin::world
