// SPDX-License-Identifier: MIT
#include "twin/serve/terminal_wire.hpp"

#include <array>
#include <utility>

namespace sensotwin::twin {
namespace {

constexpr std::size_t kChunkBytes = 4096;  // Chosen: what a terminal's queue holds
/// Taken in one go before the others have their turn. Chosen: decoded within a fraction of a millisecond.
constexpr int kChunksAtOnce = 16;

}  // namespace

TerminalWire::TerminalWire(std::string name, const std::filesystem::path& link, robot::ByteLink& device,
                           TerminalWireOptions options)
    : Wire(std::move(name)), device_(device), options_(std::move(options)), terminal_(link, options_.baud) {}

void TerminalWire::do_watch(std::vector<pollfd>& handles) const {
  // Without a client the terminal would wake us all the time; whoever opens it is seen at the next tick.
  if (client_) {
    handles.push_back({.fd = terminal_.descriptor(), .events = POLLIN, .revents = 0});
  }
}

void TerminalWire::do_pump(double /*wall_s*/) {
  see_who_is_there();
  take_from_client();
  // Whoever came while we listened gets an answer to the first words too.
  see_who_is_there();
  give_to_client();
}

void TerminalWire::see_who_is_there() {
  const bool there = terminal_.has_client();
  if (there && !client_) {
    ++tally_.clients;
    if (options_.on_client) {
      options_.on_client();
    }
  } else if (!there && client_) {
    take_from_client();  // its last words
    terminal_.renew();
  }
  client_ = there;
  const auto baud = there && options_.device_baud ? terminal_.client_baud() : std::nullopt;
  wrong_baud_ = baud && *baud != options_.device_baud();
}

void TerminalWire::take_from_client() {
  std::array<std::uint8_t, kChunkBytes> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (int i = 0; i < kChunksAtOnce; ++i) {
    const std::size_t size = terminal_.read(chunk);
    if (size == 0) {
      return;
    }
    tally_.bytes_in += size;
    const bool garbled = wrong_baud_ && options_.strict_baud;
    if (garbled || !device_.write(robot::ByteView{chunk}.first(size))) {
      tally_.bytes_dropped += size;
    }
  }
}

void TerminalWire::give_to_client() {
  std::array<std::uint8_t, kChunkBytes> chunk;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  while (const std::size_t size = device_.read(chunk)) {
    if (!client_) {
      continue;  // said to nobody
    }
    const bool lost = wrong_baud_ && options_.strict_baud;
    const std::size_t taken = lost ? 0 : terminal_.write(robot::ByteView{chunk}.first(size));
    tally_.bytes_out += taken;
    tally_.bytes_dropped += size - taken;
  }
}

bool TerminalWire::client_is_up_to_date() const {
  return client_ && terminal_.unread() == std::size_t{0};
}

}  // namespace sensotwin::twin
