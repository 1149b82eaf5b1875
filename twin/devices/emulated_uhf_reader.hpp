// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/bytes.hpp"
#include "robot/base/time.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/wire/llrp/codec.hpp"
#include "twin/devices/radio_reading.hpp"
#include "twin/devices/uhf_access.hpp"
#include "twin/devices/uhf_link.hpp"
#include "twin/devices/uhf_report_buffer.hpp"
#include "twin/devices/uhf_ro_spec.hpp"
#include "twin/devices/uhf_settings.hpp"

namespace sensotwin::twin {

/// Counters since construction.
struct UhfReaderTally {
  std::uint64_t requests{0};
  std::uint64_t refused{0};       ///< answered with another status than success
  std::uint64_t readings{0};      ///< made while a ROSpec asked for them
  std::uint64_t reports{0};       ///< RO_ACCESS_REPORTs
  std::uint64_t reports_lost{0};  ///< nobody was connected, or nobody took them
  std::uint64_t connections{0};
  std::uint64_t keepalives{0};
  std::uint64_t keepalive_acks{0};
};

/// An Impinj Speedway R420 as a client sees it (protocols study, part 2): LLRP 1.0.1, one client at a time,
/// one ROSpec, AccessSpecs, Impinj's phase, RSSI and Doppler for a client that has enabled them on this
/// connection.
///
/// Bytes in, bytes out: connect(), receive(), send(), disconnect() are what a TCP server needs; link() is the
/// same for a client in this process. Time enters by step() and by the readings. A request is answered at the
/// instant it arrives. Its ROSpec goes on when the client goes; reports that nobody takes are dropped.
/// Leaves out: LLRP 1.1, GPIs, RF surveys, client request operations.
class EmulatedUhfReader final : private RoSpecListener {
 public:
  /// \param memory  user banks of the tags; none: tags without one
  explicit EmulatedUhfReader(UhfReaderSettings settings, UserMemory memory = {});
  EmulatedUhfReader(const EmulatedUhfReader&) = delete;
  EmulatedUhfReader& operator=(const EmulatedUhfReader&) = delete;

  /// Time goes on to `now`: triggers, keepalives, the in-memory link. \param now  never earlier than before
  void step(robot::Instant now);
  /// A tag has answered. Best told in the order of time, before step() of that time; one that comes late
  /// keeps its own time stamp. \returns false, making nothing of it, while no ROSpec reads through that
  /// antenna
  bool report(const RadioReading& reading);
  /// Ports that read now, in the order of their turns; none while nothing is active.
  [[nodiscard]] std::span<const std::uint16_t> antennas() const { return ro_spec_.antennas(); }

  /// A client has connected: it will be sent the connection event. \returns false when another one is
  /// connected, which is told so; the new one is to be sent refusal() and closed
  bool connect();
  /// What a client that comes second is told before its connection is closed.
  [[nodiscard]] robot::Bytes refusal();
  /// The client is gone.
  void disconnect();
  /// False before connect(), after disconnect(), and once the reader has closed and all is sent.
  [[nodiscard]] bool is_connected() const { return connected_ && !(closing_ && out_.empty()); }
  /// The reader ends the connection of its own accord: its last message says so.
  void close();
  /// It has said its last message, or is about to: nothing more is heard.
  [[nodiscard]] bool is_closing() const { return closing_; }
  /// Bytes from the client.
  void receive(robot::ByteView bytes);
  /// Moves bytes for the client that are due into `into`. \returns how many
  [[nodiscard]] std::size_t send(std::span<std::uint8_t> into);

  [[nodiscard]] UhfLink& link() { return link_; }
  [[nodiscard]] const UhfReaderTally& tally() const { return tally_; }

 private:
  struct Outgoing {
    robot::Instant due;
    robot::Bytes bytes;
  };

  void handle(const robot::llrp::Frame& frame);
  void answer_fault(const robot::llrp::FrameHeader& header, const robot::llrp::DecodeError& error);
  void unsupported(std::uint32_t id);
  template <class T>
  void on(const T& /*not a request*/, std::uint32_t id) {
    unsupported(id);
  }
  void on(const robot::llrp::GetReaderCapabilities& request, std::uint32_t id);
  void on(const robot::llrp::GetReaderConfig& request, std::uint32_t id);
  void on(const robot::llrp::SetReaderConfig& request, std::uint32_t id);
  void on(const robot::llrp::AddRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::DeleteRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::StartRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::StopRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::EnableRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::DisableRoSpec& request, std::uint32_t id);
  void on(const robot::llrp::GetRoSpecs& request, std::uint32_t id);
  void on(const robot::llrp::AddAccessSpec& request, std::uint32_t id);
  void on(const robot::llrp::DeleteAccessSpec& request, std::uint32_t id);
  void on(const robot::llrp::EnableAccessSpec& request, std::uint32_t id);
  void on(const robot::llrp::DisableAccessSpec& request, std::uint32_t id);
  void on(const robot::llrp::GetAccessSpecs& request, std::uint32_t id);
  void on(const robot::llrp::GetReport& request, std::uint32_t id);
  void on(const robot::llrp::EnableEventsAndReports& request, std::uint32_t id);
  void on(const robot::llrp::CloseConnection& request, std::uint32_t id);
  void on(const robot::llrp::ImpinjEnableExtensions& request, std::uint32_t id);
  void on(const robot::llrp::KeepaliveAck& /*ack*/, std::uint32_t /*id*/) { ++tally_.keepalive_acks; }
  void on(const robot::llrp::ErrorMessage& /*error*/, std::uint32_t /*id*/) {}

  template <robot::llrp::MessageType Type>
  void answer(robot::llrp::LlrpStatus status, std::uint32_t id);
  void put(const robot::llrp::Message& message, std::uint32_t id, robot::Duration latency = {});
  /// A message that the client may be spared: reports and events.
  void put_or_lose(const robot::llrp::Message& message, robot::Duration latency = {});
  void put_event(robot::llrp::EventKind kind, robot::llrp::ReaderEvent event);
  void flush_report();
  void run_access(const RadioReading& reading);
  [[nodiscard]] robot::llrp::ReaderEvent event_now() const;

  void ro_spec_started(std::uint32_t id) override;
  void ai_spec_ended(std::uint32_t id, std::uint16_t spec_index) override;
  void ro_spec_ended(std::uint32_t id) override;

  UhfReaderSettings settings_;
  robot::llrp::GetReaderConfigResponse config_;
  RoSpecRunner ro_spec_;
  AccessSpecs access_;
  UhfReportBuffer entries_;
  UhfLink link_;
  robot::llrp::FrameDecoder in_;
  robot::Instant now_{};
  bool connected_{false};
  bool closing_{false};
  bool extended_{false};  ///< Impinj's extensions are enabled on this connection
  bool holding_{false};   ///< events and reports wait for ENABLE_EVENTS_AND_REPORTS
  std::vector<robot::llrp::Message> held_;
  std::deque<Outgoing> out_;
  std::size_t out_bytes_{0};
  std::size_t sent_of_first_{0};
  std::uint32_t next_id_{1};  ///< of messages the reader sends unasked; runs on across connections
  std::optional<robot::Instant> next_keepalive_;
  UhfReaderTally tally_;
};

}  // namespace sensotwin::twin
