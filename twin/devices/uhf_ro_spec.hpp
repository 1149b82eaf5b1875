// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/wire/llrp/inventory.hpp"
#include "robot/wire/llrp/status.hpp"
#include "twin/devices/radio_reading.hpp"
#include "twin/devices/uhf_report_buffer.hpp"

namespace sensotwin::twin {

/// Told by the runner as a ROSpec lives.
class RoSpecListener {
 public:
  virtual ~RoSpecListener() = default;
  virtual void ro_spec_started(std::uint32_t id) = 0;
  virtual void ai_spec_ended(std::uint32_t id, std::uint16_t spec_index) = 0;
  virtual void ro_spec_ended(std::uint32_t id) = 0;
};

/// The one ROSpec that an R420 holds, and its states (LLRP 1.0.1, 10.1 and 10.2; protocols study, 2.5):
///
///     ADD -> disabled -> ENABLE -> inactive -> (start trigger, START) -> active -> (AISpecs done, stop
///     trigger, STOP) -> inactive
///
/// An immediate one starts again whenever it gets back to inactive by itself, but not after STOP. An AISpec
/// ends by its duration or by tag observations; N attempts to see all tags count as N rounds of 14 ms and
/// antenna (data study, 3.8). Leaves out: GPI triggers (accepted, nothing is wired to them), preemption (one
/// priority), UTC starts of periodic triggers.
class RoSpecRunner {
 public:
  RoSpecRunner(const UhfReaderSettings& settings, RoSpecListener& listener)
      : settings_(settings), listener_(listener) {}

  [[nodiscard]] robot::llrp::LlrpStatus add(const robot::llrp::RoSpec& spec);
  /// Of these, 0 means all but for start() and stop(), which refuse it.
  [[nodiscard]] robot::llrp::LlrpStatus remove(std::uint32_t id);
  [[nodiscard]] robot::llrp::LlrpStatus enable(std::uint32_t id, robot::Instant now);
  [[nodiscard]] robot::llrp::LlrpStatus disable(std::uint32_t id);
  [[nodiscard]] robot::llrp::LlrpStatus start(std::uint32_t id, robot::Instant now);
  [[nodiscard]] robot::llrp::LlrpStatus stop(std::uint32_t id);

  /// Time goes on: triggers fire at their instants.
  void step(robot::Instant now);
  /// Whether a reading through `antenna` is made now.
  [[nodiscard]] bool reads(std::uint16_t antenna) const;
  /// Ports in use now, in the order of the AISpec; none while nothing is active.
  [[nodiscard]] std::span<const std::uint16_t> antennas() const { return antennas_; }
  [[nodiscard]] ReadingContext context() const;
  /// Counts a reading towards the tag observation trigger; may end the AISpec. \pre reads(reading.antenna)
  void observe(const RadioReading& reading);
  [[nodiscard]] const std::optional<robot::llrp::RoSpec>& spec() const { return spec_; }
  [[nodiscard]] bool is_active() const;

 private:
  [[nodiscard]] bool names(std::uint32_t id) const { return spec_ && (id == 0 || spec_->id == id); }
  void begin(robot::Instant at);
  void begin_ai_spec(robot::Instant at);
  void end_ai_spec(robot::Instant at);
  void end(robot::Instant at, bool by_itself);
  [[nodiscard]] std::optional<robot::Instant> ai_spec_due() const;
  [[nodiscard]] std::optional<robot::Instant> ro_spec_due() const;

  const UhfReaderSettings& settings_;
  RoSpecListener& listener_;
  std::optional<robot::llrp::RoSpec> spec_;
  std::optional<robot::Instant> next_start_;  ///< of a periodic or immediate trigger
  robot::Instant begun_{};
  std::size_t index_{0};  ///< of the AISpec under way
  robot::Instant ai_begun_{};
  robot::Instant last_new_tag_{};
  std::uint32_t observations_{0};
  std::set<robot::Epc> seen_;
  std::vector<std::uint16_t> antennas_;
};

/// A status that refuses a request because of one parameter, or one field of it.
[[nodiscard]] robot::llrp::LlrpStatus refused(std::uint16_t parameter, robot::llrp::StatusCode code);
[[nodiscard]] robot::llrp::LlrpStatus refused_field(std::uint16_t field, robot::llrp::StatusCode code);
[[nodiscard]] robot::llrp::LlrpStatus refused_field_in(std::uint16_t parameter, std::uint16_t field,
                                                       robot::llrp::StatusCode code);

}  // namespace sensotwin::twin
