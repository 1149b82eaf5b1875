// SPDX-License-Identifier: MIT
// The requests of LLRP, as an emulated R420 answers them.
#include <chrono>
#include <utility>

#include "twin/devices/emulated_uhf_reader.hpp"
#include "twin/devices/uhf_requests.hpp"

namespace sensotwin::twin {
namespace llrp = robot::llrp;
using llrp::MessageType;
using llrp::StatusCode;

void EmulatedUhfReader::handle(const llrp::Frame& frame) {
  ro_spec_.step(now_);
  const auto message = llrp::decode(frame);
  if (!message) {
    answer_fault(frame.header, message.error());
    return;
  }
  std::visit([this, id = frame.header.id](const auto& request) { on(request, id); }, *message);
}

void EmulatedUhfReader::answer_fault(const llrp::FrameHeader& header, const llrp::DecodeError& error) {
  const llrp::LlrpStatus status = llrp::status_of(error);
  if (error.fault == llrp::Fault::kUnsupportedVersion) {
    // Told in the version of the client, and nothing but the code: clients ask for it to find out what is
    // spoken.
    ++tally_.requests;
    ++tally_.refused;
    out_.push_back({now_, llrp::encode(llrp::ErrorMessage{{.code = StatusCode::kUnsupportedVersion}},
                                       header.id, header.version)});
    out_bytes_ += out_.back().bytes.size();
    return;
  }
  if (auto refusal = refusal_of(static_cast<MessageType>(header.type), status)) {
    ++tally_.requests;
    ++tally_.refused;
    put(*refusal, header.id);
  }
}

void EmulatedUhfReader::unsupported(std::uint32_t id) {
  ++tally_.requests;
  ++tally_.refused;
  put(llrp::ErrorMessage{{.code = StatusCode::kUnsupportedMessage, .description = "unsupported message"}},
      id);
}

template <MessageType Type>
void EmulatedUhfReader::answer(llrp::LlrpStatus status, std::uint32_t id) {
  ++tally_.requests;
  tally_.refused += status.ok() ? 0 : 1;
  put(llrp::StatusMessage<Type>{std::move(status)}, id);
}

void EmulatedUhfReader::on(const llrp::GetReaderCapabilities& request, std::uint32_t id) {
  using Wanted = llrp::CapabilitiesWanted;
  const auto wants = [&request](Wanted part) {
    return request.wanted == Wanted::kAll || request.wanted == part;
  };
  ++tally_.requests;
  llrp::GetReaderCapabilitiesResponse out = uhf_capabilities(settings_);
  if (!wants(Wanted::kGeneral)) {
    out.general.reset();
  }
  if (!wants(Wanted::kLlrp)) {
    out.llrp.reset();
  }
  if (!wants(Wanted::kRegulatory)) {
    out.regulatory.reset();
  }
  if (!wants(Wanted::kAirProtocol)) {
    out.c1g2.reset();
  }
  put(out, id);
}

void EmulatedUhfReader::on(const llrp::GetReaderConfig& request, std::uint32_t id) {
  ++tally_.requests;
  if (request.antenna > settings_.antennas) {
    ++tally_.refused;
    put(llrp::GetReaderConfigResponse{.status = refused_field(1, StatusCode::kFieldOutOfRange)}, id);
    return;
  }
  put(part_of(config_, request), id);
}

void EmulatedUhfReader::on(const llrp::SetReaderConfig& request, std::uint32_t id) {
  llrp::LlrpStatus status = check_customs(request, extended_);
  if (status.ok()) {
    status = apply(request, settings_, config_);
  }
  if (status.ok() && request.reset_to_factory) {
    static_cast<void>(ro_spec_.remove(0));
    static_cast<void>(access_.remove(0));
  }
  if (status.ok() && (request.keepalive || request.reset_to_factory)) {
    next_keepalive_.reset();
    if (config_.keepalive->trigger == llrp::KeepaliveTrigger::kPeriodic) {
      next_keepalive_ = now_ + std::chrono::milliseconds{config_.keepalive->period_ms};
    }
  }
  answer<MessageType::kSetReaderConfigResponse>(std::move(status), id);
}

void EmulatedUhfReader::on(const llrp::AddRoSpec& request, std::uint32_t id) {
  llrp::LlrpStatus status = check_customs(request.spec, extended_);
  answer<MessageType::kAddRoSpecResponse>(status.ok() ? ro_spec_.add(request.spec) : status, id);
}
void EmulatedUhfReader::on(const llrp::DeleteRoSpec& request, std::uint32_t id) {
  answer<MessageType::kDeleteRoSpecResponse>(ro_spec_.remove(request.id), id);
}
void EmulatedUhfReader::on(const llrp::StartRoSpec& request, std::uint32_t id) {
  answer<MessageType::kStartRoSpecResponse>(ro_spec_.start(request.id, now_), id);
}
void EmulatedUhfReader::on(const llrp::StopRoSpec& request, std::uint32_t id) {
  answer<MessageType::kStopRoSpecResponse>(ro_spec_.stop(request.id), id);
}
void EmulatedUhfReader::on(const llrp::EnableRoSpec& request, std::uint32_t id) {
  answer<MessageType::kEnableRoSpecResponse>(ro_spec_.enable(request.id, now_), id);
  ro_spec_.step(now_);
}
void EmulatedUhfReader::on(const llrp::DisableRoSpec& request, std::uint32_t id) {
  answer<MessageType::kDisableRoSpecResponse>(ro_spec_.disable(request.id), id);
}
void EmulatedUhfReader::on(const llrp::GetRoSpecs& /*request*/, std::uint32_t id) {
  ++tally_.requests;
  llrp::GetRoSpecsResponse out;
  if (ro_spec_.spec()) {
    out.specs.push_back(*ro_spec_.spec());
  }
  put(out, id);
}

void EmulatedUhfReader::on(const llrp::AddAccessSpec& request, std::uint32_t id) {
  llrp::LlrpStatus status = check_customs(request.spec, extended_);
  answer<MessageType::kAddAccessSpecResponse>(
      status.ok() ? access_.add(request.spec, settings_.antennas) : status, id);
}
void EmulatedUhfReader::on(const llrp::DeleteAccessSpec& request, std::uint32_t id) {
  answer<MessageType::kDeleteAccessSpecResponse>(access_.remove(request.id), id);
}
void EmulatedUhfReader::on(const llrp::EnableAccessSpec& request, std::uint32_t id) {
  answer<MessageType::kEnableAccessSpecResponse>(access_.set_active(request.id, true), id);
}
void EmulatedUhfReader::on(const llrp::DisableAccessSpec& request, std::uint32_t id) {
  answer<MessageType::kDisableAccessSpecResponse>(access_.set_active(request.id, false), id);
}
void EmulatedUhfReader::on(const llrp::GetAccessSpecs& /*request*/, std::uint32_t id) {
  ++tally_.requests;
  put(llrp::GetAccessSpecsResponse{.specs = access_.all()}, id);
}

void EmulatedUhfReader::on(const llrp::GetReport& /*request*/, std::uint32_t /*id*/) {
  ++tally_.requests;
  flush_report();
}
void EmulatedUhfReader::on(const llrp::EnableEventsAndReports& /*request*/, std::uint32_t /*id*/) {
  ++tally_.requests;
  holding_ = false;
  for (const llrp::Message& message : std::exchange(held_, {})) {
    put(message, next_id_++);
  }
}
void EmulatedUhfReader::on(const llrp::CloseConnection& /*request*/, std::uint32_t id) {
  answer<MessageType::kCloseConnectionResponse>({}, id);
  closing_ = true;
}
void EmulatedUhfReader::on(const llrp::ImpinjEnableExtensions& /*request*/, std::uint32_t id) {
  if (!settings_.impinj_extensions) {
    unsupported(id);
    return;
  }
  ++tally_.requests;
  extended_ = true;
  put(llrp::ImpinjEnableExtensionsResponse{}, id);
}

}  // namespace sensotwin::twin
