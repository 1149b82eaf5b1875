// SPDX-License-Identifier: MIT
#include "robot/journal/journal_writer.hpp"

#include <cassert>
#include <utility>

#include "robot/journal/journal_bytes.hpp"

namespace sensotwin::robot {
namespace {

void append(Bytes& to, std::string_view text) {
  to.insert(to.end(), text.begin(), text.end());
}

}  // namespace

JournalWriter::JournalWriter(Sink sink, std::string_view robot_file) : sink_(std::move(sink)) {
  append(block_, kJournalMagic);
  append_number(block_, robot_file.size());
  append(block_, robot_file);
  give(block_);
}

void JournalWriter::add(Wire wire, WireWord word, ByteView bytes) {
  assert(bytes.empty() || has_bytes(word));
  records_.push_back(static_cast<std::uint8_t>(static_cast<int>(wire) * 16 + static_cast<int>(word)));
  if (has_bytes(word)) {
    append_number(records_, bytes.size());
    records_.insert(records_.end(), bytes.begin(), bytes.end());
  }
}

void JournalWriter::end_block(char kind, Instant now) {
  Bytes payload;
  append_number(payload, static_cast<std::uint64_t>((now - last_).count()));
  payload.insert(payload.end(), records_.begin(), records_.end());
  last_ = now;
  records_.clear();

  block_.clear();
  block_.push_back(static_cast<std::uint8_t>(kind));
  append_number(block_, payload.size());
  block_.insert(block_.end(), payload.begin(), payload.end());
  const std::uint32_t check = check_of(payload);
  for (int shift = 0; shift < 32; shift += 8) {
    block_.push_back(static_cast<std::uint8_t>(check >> shift));
  }
  give(block_);
}

void JournalWriter::give(ByteView bytes) {
  if (!failed_) {
    failed_ = !sink_(bytes);
    bytes_written_ += failed_ ? 0 : bytes.size();
  }
}

}  // namespace sensotwin::robot
