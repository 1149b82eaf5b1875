// SPDX-License-Identifier: MIT
#include "twin/devices/uhf_access.hpp"

#include <algorithm>
#include <utility>

#include "twin/devices/uhf_ro_spec.hpp"

namespace sensotwin::twin {
namespace llrp = robot::llrp;
using llrp::StatusCode;
namespace {

/// R420 (protocols study, 2.4).
constexpr std::size_t kMaxSpecs = 1508;
constexpr std::size_t kMaxOperations = 8;
constexpr std::uint16_t kPcOfNinetySixBits = 0x3000;

/// CRC-16 of the C1G2 air protocol (EPC Gen2 1.2.0, 6.3.1.5): polynomial 0x1021, preset FFFF, complemented.
[[nodiscard]] std::uint16_t crc16(const std::vector<std::uint16_t>& words) {
  unsigned crc = 0xFFFFu;
  for (const std::uint16_t word : words) {
    crc ^= word;
    for (int i = 0; i < 16; ++i) {
      crc = (crc & 0x8000u) != 0 ? ((crc << 1) ^ 0x1021u) & 0xFFFFu : (crc << 1) & 0xFFFFu;
    }
  }
  return static_cast<std::uint16_t>(~crc);
}

[[nodiscard]] bool matches(const llrp::C1G2TargetTag& target, const std::vector<std::uint16_t>& words) {
  bool same = true;
  for (std::size_t i = 0; i < target.mask.count && same; ++i) {
    if (target.mask.bit(i)) {
      const std::size_t at = target.bit_pointer + i;
      same = at / 16 < words.size() && i < target.data.count &&
             (((words[at / 16] >> (15 - at % 16)) & 1) != 0) == target.data.bit(i);
    }
  }
  return target.mask.count == 0 || same == target.match;
}

[[nodiscard]] bool succeeded(const llrp::C1G2OpResult& result) {
  return std::visit([](const auto& r) { return static_cast<int>(r.result) == 0; }, result);
}

}  // namespace

llrp::LlrpStatus AccessSpecs::add(const llrp::AccessSpec& spec, std::uint16_t antennas) {
  const auto same = std::ranges::find(specs_, spec.id, &llrp::AccessSpec::id);
  if (spec.id == 0 || same != specs_.end()) {
    return refused_field_in(llrp::AccessSpec::kType, 1, StatusCode::kInvalidField);
  }
  if (spec.antenna > antennas) {
    return refused_field_in(llrp::AccessSpec::kType, 2, StatusCode::kFieldOutOfRange);
  }
  if (spec.protocol != 1 || spec.active) {
    return refused_field_in(llrp::AccessSpec::kType, spec.active ? 4 : 3, StatusCode::kInvalidField);
  }
  if (specs_.size() == kMaxSpecs || spec.command.operations.size() > kMaxOperations) {
    return refused(llrp::AccessSpec::kType, StatusCode::kInOverflowParameter);
  }
  for (const llrp::C1G2OpSpec& op : spec.command.operations) {
    if (std::holds_alternative<llrp::C1G2BlockErase>(op)) {
      return refused(llrp::C1G2BlockErase::kType, StatusCode::kInUnsupportedParameter);
    }
  }
  specs_.push_back(spec);
  return {};
}

llrp::LlrpStatus AccessSpecs::remove(std::uint32_t id) {
  if (id == 0) {
    specs_.clear();
    return {};
  }
  const bool found = std::erase_if(specs_, [id](const auto& spec) { return spec.id == id; }) > 0;
  return found ? llrp::LlrpStatus{} : refused_field(1, StatusCode::kInvalidField);
}

llrp::LlrpStatus AccessSpecs::set_active(std::uint32_t id, bool active) {
  bool found = id == 0;
  for (llrp::AccessSpec& spec : specs_) {
    if (id == 0 || spec.id == id) {
      spec.active = active;
      found = true;
    }
  }
  return found ? llrp::LlrpStatus{} : refused_field(1, StatusCode::kInvalidField);
}

std::vector<std::uint16_t> AccessSpecs::bank(llrp::MemoryBank which, const robot::Epc& epc) const {
  std::vector<std::uint16_t> out;
  if (which == llrp::MemoryBank::kEpc) {
    out.push_back(kPcOfNinetySixBits);
    for (std::size_t i = 0; i < epc.bytes.size(); i += 2) {
      out.push_back(robot::u16_from_be(epc.bytes[i], epc.bytes[i + 1]));
    }
    out.insert(out.begin(), crc16(out));
  } else if (which == llrp::MemoryBank::kUser && memory_) {
    const auto words = memory_(epc);
    out.assign(words.begin(), words.end());
  }
  return out;
}

bool AccessSpecs::means(const llrp::AccessSpec& spec, const RadioReading& reading,
                        std::uint32_t ro_spec_id) const {
  const bool in_scope = spec.active && (spec.antenna == 0 || spec.antenna == reading.antenna) &&
                        (spec.ro_spec_id == 0 || spec.ro_spec_id == ro_spec_id);
  return in_scope && std::ranges::all_of(spec.command.tags.targets, [&](const llrp::C1G2TargetTag& target) {
           return matches(target, bank(target.bank, reading.epc));
         });
}

std::optional<AccessOutcome> AccessSpecs::try_on(const RadioReading& reading, std::uint32_t ro_spec_id,
                                                 llrp::AccessReportTrigger default_report) {
  const auto spec =
      std::ranges::find_if(specs_, [&](const auto& each) { return means(each, reading, ro_spec_id); });
  if (spec == specs_.end()) {
    return std::nullopt;
  }
  AccessOutcome out{spec->id, {}, spec->report ? spec->report->trigger : default_report};
  for (const llrp::C1G2OpSpec& op : spec->command.operations) {
    out.results.push_back(std::visit([&](const auto& what) { return carry_out(what, reading.epc); }, op));
    if (!succeeded(out.results.back())) {
      break;
    }
  }
  if (spec->stop.kind == llrp::AccessStop::kCount && spec->stop.count > 0 && --spec->stop.count == 0) {
    specs_.erase(spec);
  }
  return out;
}

llrp::C1G2OpResult AccessSpecs::carry_out(const llrp::C1G2Read& op, const robot::Epc& epc) {
  if (op.password != 0) {
    return llrp::C1G2ReadResult{llrp::ReadResult::kNoResponse, op.op, {}};
  }
  const std::vector<std::uint16_t> words = bank(op.bank, epc);
  const std::size_t last = op.count == 0 ? words.size() : std::size_t{op.word} + op.count;
  if (op.word >= words.size() || last > words.size()) {
    return llrp::C1G2ReadResult{llrp::ReadResult::kTagError, op.op, {}};
  }
  return llrp::C1G2ReadResult{
      llrp::ReadResult::kSuccess, op.op, {words.begin() + op.word, words.begin() + static_cast<long>(last)}};
}

template <std::uint16_t Type>
llrp::C1G2OpResult AccessSpecs::carry_out(const llrp::C1G2Writing<Type>& op, const robot::Epc& epc) {
  // The result's type is not a fixed step from the operation's: 342 has 350, 347 has 354.
  using Answer =
      std::conditional_t<Type == llrp::C1G2Write::kType, llrp::C1G2WriteResult, llrp::C1G2BlockWriteResult>;
  if (op.password != 0) {
    return Answer{llrp::WriteResult::kNoResponse, op.op, 0};
  }
  if (op.bank != llrp::MemoryBank::kUser) {
    return Answer{llrp::WriteResult::kMemoryLocked, op.op, 0};
  }
  const auto words = memory_ ? memory_(epc) : std::span<std::uint16_t>{};
  if (op.word + op.data.size() > words.size()) {
    return Answer{llrp::WriteResult::kMemoryOverrun, op.op, 0};
  }
  std::ranges::copy(op.data, words.begin() + op.word);
  return Answer{llrp::WriteResult::kSuccess, op.op, static_cast<std::uint16_t>(op.data.size())};
}

llrp::C1G2OpResult AccessSpecs::carry_out(const llrp::C1G2Kill& op, const robot::Epc& /*epc*/) {
  constexpr std::uint8_t kZeroPasswordError = 1;
  return llrp::C1G2KillResult{kZeroPasswordError, op.op};
}
llrp::C1G2OpResult AccessSpecs::carry_out(const llrp::C1G2Lock& op, const robot::Epc& /*epc*/) {
  constexpr std::uint8_t kNonSpecificTagError = 2;
  return llrp::C1G2LockResult{kNonSpecificTagError, op.op};
}
llrp::C1G2OpResult AccessSpecs::carry_out(const llrp::C1G2BlockErase& op, const robot::Epc& /*epc*/) {
  constexpr std::uint8_t kNonSpecificTagError = 4;
  return llrp::C1G2BlockEraseResult{kNonSpecificTagError, op.op};
}

}  // namespace sensotwin::twin
