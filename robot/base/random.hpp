// SPDX-License-Identifier: MIT
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace sensotwin::robot {

/// A named stream of random numbers.
///
/// A child depends on its parent's seed and its own name, never on the order of creation or on how much
/// others drew: adding a sensor moves nobody else's noise. Counter-based (Philox 4x32-10, Salmon et al.,
/// SC'11, from Random123), so that equal (seed, name, draw number) give equal numbers on every machine. The
/// normal law is our own Box-Muller because std::normal_distribution differs between standard libraries.
class RandomStream {
 public:
  constexpr explicit RandomStream(std::uint64_t seed) : seed_(seed) {}

  /// Stream `name` below this one. Draws nothing. FNV-1a over seed and name.
  [[nodiscard]] constexpr RandomStream fork(std::string_view name) const {
    std::uint64_t h = 0xcbf29ce484222325u;
    for (int i = 0; i < 8; ++i) {
      h = (h ^ ((seed_ >> (8 * i)) & 0xFFu)) * 0x100000001b3u;
    }
    for (const char c : name) {
      h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    }
    return RandomStream{h};
  }

  [[nodiscard]] std::uint64_t next_u64() {
    const std::uint64_t low = next_u32();
    return (static_cast<std::uint64_t>(next_u32()) << 32) | low;
  }
  /// Uniform in [0, 1), 53 bits.
  [[nodiscard]] double uniform() { return static_cast<double>(next_u64() >> 11) * 0x1.0p-53; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 .. n-1 by Lemire's multiplication; the bias is below n / 2^64. \pre n > 0
  [[nodiscard]] std::uint32_t below(std::uint32_t n) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint32_t>((static_cast<Wide>(next_u64()) * n) >> 64);
  }
  [[nodiscard]] bool chance(double probability) { return uniform() < probability; }
  /// Standard normal (Box and Muller, Ann. Math. Stat. 29(2), 1958).
  [[nodiscard]] double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }
  [[nodiscard]] double normal(double mean, double sigma) { return mean + sigma * normal(); }
  [[nodiscard]] constexpr std::uint64_t seed() const { return seed_; }

 private:
  [[nodiscard]] std::uint32_t next_u32() {
    if (used_ == 4) {
      const r123::Philox4x32::ctr_type counter = {
          {static_cast<std::uint32_t>(block_), static_cast<std::uint32_t>(block_ >> 32), 0u, 0u}};
      const r123::Philox4x32::key_type key = {
          {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)}};
      const auto out = r123::Philox4x32{}(counter, key);
      words_ = {out[0], out[1], out[2], out[3]};
      ++block_;
      used_ = 0;
    }
    return words_[used_++];
  }

  std::uint64_t seed_;
  std::uint64_t block_{0};
  std::array<std::uint32_t, 4> words_{};
  unsigned used_{4};
  bool has_spare_{false};
  double spare_{0.0};
};

}  // namespace sensotwin::robot
