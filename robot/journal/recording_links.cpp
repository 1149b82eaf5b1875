// SPDX-License-Identifier: MIT
#include "robot/journal/recording_links.hpp"

#include "robot/journal/journal_words.hpp"

namespace sensotwin::robot {

bool RecordingByteLink::do_write(ByteView bytes) {
  const bool taken = inner_.write(bytes);
  journal_.add(wire_, taken ? WireWord::kWritten : WireWord::kWriteRefused, bytes);
  return taken;
}

std::size_t RecordingByteLink::do_read(std::span<std::uint8_t> into) {
  const std::size_t size = inner_.read(into);
  if (size > 0) {
    journal_.add(wire_, WireWord::kRead, into.first(size));
  }
  return size;
}

bool RecordingByteLink::do_is_up() const {
  const bool up = inner_.is_up();
  if (was_up_ != up) {
    journal_.add(wire_, up ? WireWord::kUp : WireWord::kDown);
    was_up_ = up;
  }
  return up;
}

CardPresence RecordingCardLink::do_presence() {
  const CardPresence presence = inner_.presence();
  if (was_ != presence) {
    journal_.add(wire_, word_of(presence));
    was_ = presence;
  }
  return presence;
}

bool RecordingCardLink::do_begin(ByteView command_apdu) {
  const bool begun = inner_.begin(command_apdu);
  journal_.add(wire_, begun ? WireWord::kBegun : WireWord::kBeginRefused, command_apdu);
  return begun;
}

std::optional<Result<Bytes, CardError>> RecordingCardLink::do_poll() {
  auto answer = inner_.poll();
  if (answer && *answer) {
    journal_.add(wire_, WireWord::kAnswer, **answer);
  } else if (answer) {
    journal_.add(wire_, word_of(answer->error()));
  }
  return answer;
}

}  // namespace sensotwin::robot
