// SPDX-License-Identifier: MIT
#include "twin/run/phase_noise.hpp"

#include <fmt/format.h>

#include <cmath>

#include "world/radio/radio.hpp"

namespace sensotwin::twin {
namespace {

/// Dots drawn at most. Chosen: they still show as dots.
constexpr std::size_t kMostDots = 4000;
constexpr double kBin_m = 0.5;   ///< chosen: a run of 8 m makes sixteen
constexpr double kBin_db = 2.0;  ///< chosen: the range of a ceiling's tags makes ten
/// Fewer reads tell no deviation. Chosen: it is then known to a tenth.
constexpr long kFewest = 50;
constexpr int kCurvePoints = 60;

}  // namespace

void PhaseNoise::add(std::span<const world::RadioRead> reads) {
  for (const world::RadioRead& read : reads) {
    const double x = x_of(read);
    Bin& bin = bins_[{read.antenna, std::lround(x / (by_rssi() ? kBin_db : kBin_m))}];
    bin.sum_rad2 += read.error_rad * read.error_rad;
    ++bin.count;
    if (seen_++ % every_ != 0) {
      continue;
    }
    dots_.push_back({x, read.error_rad});
    if (dots_.size() > kMostDots) {
      // Every other goes, and from now on half as many come.
      for (std::size_t i = 0; 2 * i < dots_.size(); ++i) {
        dots_[i] = dots_[2 * i];
      }
      dots_.resize((dots_.size() + 1) / 2);
      every_ *= 2;
    }
  }
}

std::vector<render::NoiseLawView> PhaseNoise::laws() const {
  double low = 1e300;
  double high = -1e300;
  for (const render::ChartPoint& dot : dots_) {
    low = std::min(low, dot.x);
    high = std::max(high, dot.x);
  }
  const double beside_rad = std::hypot(radio_.place_sigma_rad, radio_.drift_sigma_rad);
  render::NoiseLawView read{"read noise alone", {}};
  render::NoiseLawView all{"read noise, echoes and drift", {}};
  for (int i = 0; i <= kCurvePoints; ++i) {
    const double x = low + (high - low) * i / kCurvePoints;
    const double noise_rad = world::read_noise_rad(radio_, x, x);  // the law takes one of the two
    read.curve.push_back({x, noise_rad});
    all.curve.push_back({x, std::hypot(noise_rad, beside_rad)});
  }
  return beside_rad > 0.0 ? std::vector{all, read} : std::vector{read};
}

render::NoiseView PhaseNoise::view(const Scene& scene) const {
  render::NoiseView view;
  view.title = "Phase noise of the reads";
  view.subtitle =
      fmt::format("{}, seed {}, radio {}: {} reads", scene.name, scene.seed, radio_.profile, seen_);
  if (by_rssi()) {
    view.x_label = "received signal strength (dBm)";
  }
  view.reads = dots_;
  for (const auto& [key, bin] : bins_) {
    const std::string name = fmt::format("antenna {}", key.first + 1);
    if (view.measured.empty() || view.measured.back().name != name) {
      view.measured.push_back({name, {}});
    }
    if (bin.count >= kFewest) {
      view.measured.back().points.push_back({static_cast<double>(key.second) * (by_rssi() ? kBin_db : kBin_m),
                                             std::sqrt(bin.sum_rad2 / static_cast<double>(bin.count)),
                                             std::nullopt});
    }
  }
  if (!dots_.empty()) {
    view.laws = laws();
  }
  return view;
}

}  // namespace sensotwin::twin
