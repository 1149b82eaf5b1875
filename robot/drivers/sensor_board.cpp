// SPDX-License-Identifier: MIT
#include "robot/drivers/sensor_board.hpp"

#include <array>
#include <cassert>

namespace sensotwin::robot {
namespace {

/// Bytes asked for at once, and how often in a step: 1 kB, where 38400 baud bring 58 bytes in 15 ms. More
/// is a backlog, and is worked off in the next steps instead of holding up this one.
constexpr std::size_t kChunk = 256;
constexpr int kChunksPerStep = 4;

}  // namespace

void SensorBoard::step(Instant now) {
  assert(now >= now_);
  now_ = now;
  const bool up = link_.is_up();
  if (was_up_ && !up) {
    ++health_.link_lost;
    decoder_.reset();
  }
  was_up_ = up;
  std::array<std::uint8_t, kChunk> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (int i = 0; i < kChunksPerStep; ++i) {
    const std::size_t n = link_.read(chunk);
    for (std::size_t k = 0; k < n; ++k) {
      take(chunk[k]);
    }
    if (n < chunk.size()) {
      break;
    }
  }
  if (compass_) {
    compass_->age = now - compass_->stamp;
    if (compass_->age > config_.stale_after) {
      compass_.reset();
      ++health_.went_stale;
    }
  }
  if (sonars_ && now - sonars_->stamp > config_.stale_after) {
    sonars_.reset();
    ++health_.went_stale;
  }
}

void SensorBoard::take(std::uint8_t byte) {
  const auto sentence = decoder_.push(byte);
  if (!sentence) {
    return;
  }
  if (*sentence) {
    take(**sentence);
  } else if (sentence->error() == NmeaError::kBadChecksum) {
    ++health_.bad_checksum;
  } else {
    ++health_.bad_frame;
  }
}

void SensorBoard::take(const NmeaSentence& sentence) {
  if (const auto distances = decode_distances(sentence)) {
    take(*distances);
    return;
  } else if (distances.error() != DistanceError::kNoDistances) {
    ++health_.bad_distances;
    return;
  }
  const auto heading = decode_heading(sentence);
  if (!heading) {
    switch (heading.error()) {
      case HeadingError::kNotAHeading:
        ++health_.other;
        return;
      case HeadingError::kNoHeading:
        ++health_.not_ready;
        return;
      default:
        ++health_.bad_heading;
        return;
    }
  }
  double magnetic_deg = 0.0;
  if (const auto* hdm = std::get_if<Hdm>(&*heading)) {
    magnetic_deg = hdm->magnetic_deg;
  } else if (const auto* hdg = std::get_if<Hdg>(&*heading)) {
    magnetic_deg = hdg->magnetic_deg();
  } else {
    ++health_.other;
    return;
  }
  ++health_.headings;
  compass_ = CompassReading{yaw_rad_from_heading_deg(magnetic_deg), now_, {}};
}

void SensorBoard::take(const Distances& distances) {
  if (distances.count == 0) {
    ++health_.other;
    return;
  }
  for (const Distance& distance : distances.all()) {
    range_m_[distance.sonar] = distance.metres;
    ranged_at_[distance.sonar] = now_;
    if (distance.sonar == config_.last_sonar) {
      ++health_.sonar_rounds;
      sonars_ = SonarRound{range_m_, now_};
      for (std::size_t i = 0; i < kSonarNames; ++i) {
        if (now_ - ranged_at_[i] > config_.stale_after) {
          sonars_->range_m[i].reset();
        }
      }
    }
  }
}

}  // namespace sensotwin::robot
