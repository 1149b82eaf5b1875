// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "robot/wire/llrp/codec.hpp"
#include "serve_bench.hpp"

namespace sensotwin::twin {

/// One message on the line.
struct CapturedFrame {
  bool from_reader{false};
  robot::Bytes bytes;
};

/// A client that asks a reader at a TCP port for everything it has, and keeps all that was said.
class LlrpSession {
 public:
  explicit LlrpSession(const Endpoint& at) : client_(at) {}

  void take_inventory_and_close() {
    namespace llrp = robot::llrp;
    hear_for(0.2);
    say(llrp::ImpinjEnableExtensions{});
    say(llrp::GetReaderCapabilities{});
    say(llrp::GetReaderConfig{});
    llrp::SetReaderConfig config;
    config.reset_to_factory = true;
    config.keepalive = llrp::KeepaliveSpec{.trigger = llrp::KeepaliveTrigger::kPeriodic, .period_ms = 100};
    say(config);
    llrp::RoSpec spec{.id = 7};
    spec.boundary.start.kind = llrp::RoStart::kImmediate;
    spec.ai_specs = {{.antennas = {0}, .inventory = {{.id = 1}}}};
    spec.report = llrp::RoReportSpec{.trigger = llrp::RoReportTrigger::kTagsOrEndOfAiSpec,
                                     .tags = 1,
                                     .content = {.ro_spec_id = true,
                                                 .spec_index = true,
                                                 .inventory_spec_id = true,
                                                 .antenna_id = true,
                                                 .channel_index = true,
                                                 .peak_rssi = true,
                                                 .first_seen = true,
                                                 .last_seen = true,
                                                 .tag_seen_count = true,
                                                 .access_spec_id = true}};
    spec.report->impinj = llrp::ImpinjReportContent{.phase_angle = llrp::ImpinjEnablePhaseAngle{1},
                                                    .peak_rssi = llrp::ImpinjEnablePeakRssi{1}};
    say(llrp::AddRoSpec{spec});
    say(llrp::EnableRoSpec{7});
    hear_for(1.0);
    say(llrp::GetRoSpecs{});
    say(llrp::GetAccessSpecs{});
    say(llrp::StartRoSpec{99});  // refused
    say(llrp::DisableRoSpec{7});
    say(llrp::DeleteRoSpec{7});
    say(llrp::CloseConnection{});
    hear_for(0.2);
  }

  [[nodiscard]] const std::vector<CapturedFrame>& frames() const { return frames_; }
  [[nodiscard]] bool is_over() const { return client_.is_over(); }
  [[nodiscard]] int reports() const {
    int count = 0;
    for (const CapturedFrame& frame : frames_) {
      count += frame.from_reader && type_of(frame) == 61 ? 1 : 0;
    }
    return count;
  }

 private:
  [[nodiscard]] static int type_of(const CapturedFrame& frame) {
    return robot::u16_from_be(frame.bytes[0], frame.bytes[1]) & 0x3FF;
  }
  void say(const robot::llrp::Message& message) {
    const robot::Bytes bytes = robot::llrp::encode(message, ++id_);
    frames_.push_back({.from_reader = false, .bytes = bytes});
    client_.say(bytes);
    hear_for(0.03);
  }
  void hear_for(double seconds) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < until) {
      const robot::Bytes more = client_.hear(10);
      heard_.insert(heard_.end(), more.begin(), more.end());
    }
    while (heard_.size() >= 10) {
      const std::size_t size = (std::size_t{heard_[2]} << 24) | (std::size_t{heard_[3]} << 16) |
                               (std::size_t{heard_[4]} << 8) | heard_[5];
      if (heard_.size() < size || size < 10) {
        break;
      }
      const auto end = heard_.begin() + static_cast<std::ptrdiff_t>(size);
      frames_.push_back({.from_reader = true, .bytes = robot::Bytes(heard_.begin(), end)});
      heard_.erase(heard_.begin(), end);
    }
  }

  TcpClient client_;
  robot::Bytes heard_;
  std::vector<CapturedFrame> frames_;
  std::uint32_t id_{100};
};

/// The frames as tcpdump would have captured them, one in a packet: pcap, link type 101 (raw IP), port 5084.
inline void write_capture(const std::filesystem::path& file, const std::vector<CapturedFrame>& frames) {
  std::ofstream out(file, std::ios::binary);
  const auto put = [&out](std::uint32_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) {
      out.put(static_cast<char>(value >> (8 * i)));
    }
  };
  put(0xA1B2C3D4, 4);
  put(2, 2);
  put(4, 2);
  put(0, 4);
  put(0, 4);
  put(65535, 4);
  put(101, 4);
  std::uint32_t next[2]{1, 1};  // sequence numbers of client and reader
  std::uint32_t packet = 0;
  for (const CapturedFrame& frame : frames) {
    const auto size = static_cast<std::uint32_t>(frame.bytes.size());
    put(0, 4);
    put(1000 * ++packet, 4);
    put(40 + size, 4);
    put(40 + size, 4);
    put(0x4500, 2);
    put(40 + size, 2);
    put(packet << 16, 4);  // identification, no fragments
    put(0x40060000, 4);    // 64 hops, TCP, no checksum
    put(0x7F000001, 4);
    put(0x7F000001, 4);
    put(frame.from_reader ? 5084 : 40000, 2);
    put(frame.from_reader ? 40000 : 5084, 2);
    put(next[frame.from_reader ? 1 : 0], 4);
    put(next[frame.from_reader ? 0 : 1], 4);
    put(0x5018, 2);  // 20 bytes of header, PSH and ACK
    put(65535, 2);
    put(0, 4);
    next[frame.from_reader ? 1 : 0] += size;
    out.write(reinterpret_cast<const char*>(frame.bytes.data()), static_cast<std::streamsize>(size));
  }
}

}  // namespace sensotwin::twin
