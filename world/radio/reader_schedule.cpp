// SPDX-License-Identifier: MIT
#include "world/radio/reader_schedule.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace sensotwin::world {

ReaderSchedule::ReaderSchedule(const RadioDescription& radio, std::size_t antennas)
    : simultaneous_(radio.simultaneous),
      period_s_(1.0 / radio.rate_hz),
      dwell_s_(radio.dwell_s),
      dead_s_(radio.hop_dead_s),
      per_tag_s_(radio.per_tag_s),
      silent_slot_s_(radio.silent_slot_s),
      slots_s_(radio.slots_s),
      antennas_(antennas),
      channels_(static_cast<std::uint16_t>(radio.channels_hz.size())),
      hop_due_s_(radio.dwell_s) {
  assert(channels_ > 0 && radio.rate_hz > 0.0 && radio.dwell_s > 0.0);
  assert(simultaneous_ || slots_s_.size() == antennas);
  std::iota(antennas_.begin(), antennas_.end(), std::uint16_t{0});
  use_antennas(std::vector<std::uint16_t>(antennas_), 0.0);
}

ReaderSchedule::Round ReaderSchedule::round() const {
  const std::span<const std::uint16_t> all(antennas_);
  return {.begin_s = begin_s_,
          .channel = channel_,
          .antennas = simultaneous_ || all.empty() ? all : all.subspan(turn_, 1)};
}

void ReaderSchedule::finish(std::size_t answers) {
  if (simultaneous_) {
    ++beats_;
    begin_s_ = start_s_ + static_cast<double>(beats_) * period_s_;
  } else {
    const bool silent = answers == 0 && silent_slot_s_ > 0.0;
    begin_s_ += silent ? silent_slot_s_ : slots_s_[antennas_[turn_]];
    begin_s_ += per_tag_s_ * static_cast<double>(answers - std::min<std::size_t>(1, answers));
    turn_ = (turn_ + 1) % antennas_.size();
  }
  hop_if_due();
}

void ReaderSchedule::hop_if_due() {
  if (channels_ < 2 || begin_s_ < hop_due_s_) {
    return;
  }
  channel_ = static_cast<std::uint16_t>((channel_ + 1) % channels_);
  hop_due_s_ += dwell_s_;
  if (!simultaneous_) {
    begin_s_ += dead_s_;
  }
}

void ReaderSchedule::use_antennas(std::span<const std::uint16_t> antennas, double now_s) {
  assert(simultaneous_ || std::all_of(antennas.begin(), antennas.end(),
                                      [this](std::uint16_t a) { return a < slots_s_.size(); }));
  antennas_.assign(antennas.begin(), antennas.end());
  turn_ = 0;
  beats_ = 0;
  start_s_ = now_s;
  begin_s_ = antennas_.empty() ? std::numeric_limits<double>::infinity() : now_s;
  hop_due_s_ = now_s + dwell_s_;
}

}  // namespace sensotwin::world
