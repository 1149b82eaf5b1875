// SPDX-License-Identifier: MIT
// The requests of a UHF reader's driver and their answers: set-up, and user memory.
#include <algorithm>
#include <utility>

#include "robot/drivers/uhf_reader.hpp"

namespace sensotwin::robot {
namespace {

using llrp::MessageType;

[[nodiscard]] MessageType answer_to(const llrp::Message& request) {
  const MessageType type = llrp::type_of(request);
  // LLRP 1.0.1, table 4: a response is its request + 10; Impinj's is a custom message again.
  return type == MessageType::kCustomMessage
             ? type
             : static_cast<MessageType>(static_cast<std::uint16_t>(type) + 10);
}

}  // namespace

llrp::Message UhfReader::request_of(Step step) const {
  switch (step) {
    case Step::kCapabilities:
      return llrp::GetReaderCapabilities{};
    case Step::kDeleteAccessSpecs:
      return llrp::DeleteAccessSpec{0};
    case Step::kDeleteRoSpecs:
      return llrp::DeleteRoSpec{0};
    case Step::kExtensions:
      return llrp::ImpinjEnableExtensions{};
    case Step::kSettings:
      return reader_settings(config_);
    case Step::kAddRoSpec:
      return llrp::AddRoSpec{inventory_spec(config_, extended_)};
    case Step::kEnableRoSpec:
      return llrp::EnableRoSpec{kRoSpecId};
    case Step::kMemoryAdd:
      return llrp::AddAccessSpec{*memory_spec_};
    case Step::kMemoryEnable:
      return llrp::EnableAccessSpec{kAccessSpecId};
    default:
      return llrp::DeleteAccessSpec{kAccessSpecId};
  }
}

void UhfReader::begin_setup() {
  if (memory_spec_) {
    finish_memory(Unexpected{UhfMemoryError::kConnectionLost});
  }
  ask(Step::kCapabilities);
}

void UhfReader::ask(Step step) {
  const llrp::Message request = request_of(step);
  if (step < Step::kMemoryAdd) {
    status_ = UhfReaderStatus::kSettingUp;
  }
  if (step == Step::kCapabilities) {
    extended_ = false;
  }
  awaited_ = Awaited{step, next_id_++, answer_to(request), now_ + config_.request_timeout};
  // A refused write is a link about to be down: the next step, or the deadline, tells.
  static_cast<void>(send(request, awaited_->id));
}

void UhfReader::take_answer(const llrp::Message& message, const llrp::LlrpStatus& status, std::uint32_t id) {
  const MessageType type = llrp::type_of(message);
  if (!awaited_ || awaited_->id != id || (type != awaited_->type && type != MessageType::kErrorMessage)) {
    ++health_.messages_unexpected;
    return;
  }
  const Step step = awaited_->step;
  awaited_.reset();
  if (!status.ok() || type == MessageType::kErrorMessage) {
    refused(status, step);
  } else if (const auto* capabilities = std::get_if<llrp::GetReaderCapabilitiesResponse>(&message)) {
    take_capabilities(*capabilities);
  } else {
    go_on_after(step);
  }
}

void UhfReader::take_capabilities(const llrp::GetReaderCapabilitiesResponse& capabilities) {
  channels_hz_ = robot::channels_hz(capabilities);
  const std::uint16_t highest = *std::ranges::max_element(config_.antennas);
  if (channels_hz_.empty()) {
    fail(UhfReaderFault::kNoHopTable);
  } else if (!capabilities.general || capabilities.general->antennas < highest) {
    fail(UhfReaderFault::kTooFewAntennas);
  } else {
    go_on_after(Step::kCapabilities);
  }
}

void UhfReader::refused(const llrp::LlrpStatus& status, Step step) {
  if (step >= Step::kMemoryAdd) {
    memory_refused(step);
    return;
  }
  refusal_ = status;
  if (step != Step::kExtensions) {
    fail(UhfReaderFault::kRefused);
  } else if (config_.demand_impinj_extensions) {
    fail(UhfReaderFault::kNoExtensions);
  } else {
    ask(Step::kSettings);
  }
}

void UhfReader::go_on_after(Step step) {
  switch (step) {
    case Step::kEnableRoSpec:
      status_ = UhfReaderStatus::kReading;
      retry_after_ = config_.first_retry;
      ++health_.setups;
      return;
    case Step::kMemoryEnable:
      memory_by_ = now_ + config_.memory_timeout;
      return;
    case Step::kMemoryDelete:
      memory_refused(step);
      return;
    case Step::kExtensions:
      extended_ = true;
      break;
    default:
      break;
  }
  ask(static_cast<Step>(static_cast<std::uint8_t>(step) + 1));
}

bool UhfReader::begin_memory_read(const Epc& epc, std::uint16_t word, std::uint16_t count) {
  return begin_memory(epc, llrp::C1G2Read{next_memory_op(), 0, llrp::MemoryBank::kUser, word, count});
}

bool UhfReader::begin_memory_write(const Epc& epc, std::uint16_t word, std::vector<std::uint16_t> data) {
  return begin_memory(epc,
                      llrp::C1G2Write{next_memory_op(), 0, llrp::MemoryBank::kUser, word, std::move(data)});
}

bool UhfReader::begin_memory(const Epc& epc, const llrp::C1G2OpSpec& operation) {
  if (status_ != UhfReaderStatus::kReading || memory_spec_ || awaited_) {
    return false;
  }
  memory_op_ = next_memory_op();
  memory_result_.reset();
  memory_spec_ = memory_spec(epc, operation);
  ask(Step::kMemoryAdd);
  return true;
}

void UhfReader::memory_refused(Step step) {
  // The result may have come while the DELETE was under way; that is refused then, as the AccessSpec is gone.
  if (memory_spec_) {
    finish_memory(
        Unexpected{step == Step::kMemoryDelete ? UhfMemoryError::kTagNotSeen : UhfMemoryError::kRefused});
  }
}

void UhfReader::finish_memory(UhfMemoryResult result) {
  memory_spec_.reset();
  memory_by_.reset();
  memory_result_ = std::move(result);
}

std::optional<UhfMemoryResult> UhfReader::poll_memory() {
  return std::exchange(memory_result_, std::nullopt);
}

}  // namespace sensotwin::robot
