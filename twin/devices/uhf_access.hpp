// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/wire/llrp/access.hpp"
#include "robot/wire/llrp/status.hpp"
#include "twin/devices/radio_reading.hpp"

namespace sensotwin::twin {

/// What came of trying the AccessSpecs on one tag.
struct AccessOutcome {
  std::uint32_t access_spec_id{0};
  std::vector<robot::llrp::C1G2OpResult> results;
  robot::llrp::AccessReportTrigger report{};
};

/// The AccessSpecs of a reader, and what they do to tags (LLRP 1.0.1, 11; protocols study, 2.5). On every
/// tag that is read the active ones are tried in the order of their creation; the first that means it is
/// carried out, operation by operation up to the first failure; one that has been carried out as often as it
/// says is gone. A tag has an EPC bank (CRC, PC, EPC: read only) and a user bank, and no password: with one,
/// it does not answer. Leaves out: the time an operation takes, TID banks, locks and kills (answered as a tag
/// error, changing nothing).
class AccessSpecs {
 public:
  explicit AccessSpecs(UserMemory memory) : memory_(std::move(memory)) {}

  [[nodiscard]] robot::llrp::LlrpStatus add(const robot::llrp::AccessSpec& spec, std::uint16_t antennas);
  /// 0 means all.
  [[nodiscard]] robot::llrp::LlrpStatus remove(std::uint32_t id);
  [[nodiscard]] robot::llrp::LlrpStatus set_active(std::uint32_t id, bool active);
  [[nodiscard]] const std::vector<robot::llrp::AccessSpec>& all() const { return specs_; }

  /// \returns nothing when no AccessSpec means the tag
  [[nodiscard]] std::optional<AccessOutcome> try_on(const RadioReading& reading, std::uint32_t ro_spec_id,
                                                    robot::llrp::AccessReportTrigger default_report);

 private:
  [[nodiscard]] bool means(const robot::llrp::AccessSpec& spec, const RadioReading& reading,
                           std::uint32_t ro_spec_id) const;
  [[nodiscard]] std::vector<std::uint16_t> bank(robot::llrp::MemoryBank which, const robot::Epc& epc) const;
  [[nodiscard]] robot::llrp::C1G2OpResult carry_out(const robot::llrp::C1G2Read& op, const robot::Epc& epc);
  template <std::uint16_t Type>
  [[nodiscard]] robot::llrp::C1G2OpResult carry_out(const robot::llrp::C1G2Writing<Type>& op,
                                                    const robot::Epc& epc);
  [[nodiscard]] robot::llrp::C1G2OpResult carry_out(const robot::llrp::C1G2Kill& op, const robot::Epc& epc);
  [[nodiscard]] robot::llrp::C1G2OpResult carry_out(const robot::llrp::C1G2Lock& op, const robot::Epc& epc);
  [[nodiscard]] robot::llrp::C1G2OpResult carry_out(const robot::llrp::C1G2BlockErase& op,
                                                    const robot::Epc& epc);

  UserMemory memory_;
  std::vector<robot::llrp::AccessSpec> specs_;
};

}  // namespace sensotwin::twin
