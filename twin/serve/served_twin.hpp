// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/base/random.hpp"
#include "robot/base/time.hpp"
#include "twin/devices/emulated_card_reader.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"
#include "twin/run/ceiling_radio.hpp"
#include "twin/run/machine.hpp"
#include "twin/scene/scene.hpp"

namespace sensotwin::twin {

/// A scene's world and all its devices, without the robot's program: that one comes over the wires.
class ServedTwin {
 public:
  explicit ServedTwin(const Scene& scene);

  /// World, then devices: 15 ms.
  void tick();

  [[nodiscard]] robot::Instant now() const { return machine_.now(); }
  [[nodiscard]] Machine& machine() { return machine_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] EmulatedCardReader& forward_reader() { return forward_reader_; }
  /// None in scenes without ceiling tags.
  [[nodiscard]] EmulatedUhfReader* uhf_reader() { return ceiling_ ? &ceiling_->reader() : nullptr; }

 private:
  robot::RandomStream random_;
  Machine machine_;
  EmulatedCardReader forward_reader_;
  std::optional<CeilingRadio> ceiling_;
};

}  // namespace sensotwin::twin
