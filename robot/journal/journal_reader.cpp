// SPDX-License-Identifier: MIT
#include "robot/journal/journal_reader.hpp"

#include <algorithm>
#include <optional>

#include "robot/journal/journal_bytes.hpp"

namespace sensotwin::robot {
namespace {

/// `size` bytes off the front of `bytes`, when there are as many.
std::optional<ByteView> take(ByteView& bytes, std::uint64_t size) {
  if (size > bytes.size()) {
    return std::nullopt;
  }
  const ByteView taken = bytes.first(static_cast<std::size_t>(size));
  bytes = bytes.subspan(static_cast<std::size_t>(size));
  return taken;
}

std::optional<WireRecord> take_record(ByteView& payload) {
  const std::uint8_t head = payload.front();
  payload = payload.subspan(1);
  if (head / 16 >= kWires || head % 16 >= kWireWords) {
    return std::nullopt;
  }
  WireRecord record{static_cast<Wire>(head / 16), static_cast<WireWord>(head % 16), {}};
  if (has_bytes(record.word)) {
    const auto size = take_number(payload);
    const auto bytes = size ? take(payload, *size) : std::nullopt;
    if (!bytes) {
      return std::nullopt;
    }
    record.bytes.assign(bytes->begin(), bytes->end());
  }
  return record;
}

/// A whole good block off the front of `rest`, which is left alone when there is none.
std::optional<JournalBlock> take_block(ByteView& rest, Instant last) {
  ByteView bytes = rest;
  if (bytes.empty() || (bytes.front() != 'T' && bytes.front() != 'E')) {
    return std::nullopt;
  }
  JournalBlock block;
  block.end = bytes.front() == 'E';
  bytes = bytes.subspan(1);
  const auto size = take_number(bytes);
  auto payload = size ? take(bytes, *size) : std::nullopt;
  const auto check = payload ? take(bytes, 4) : std::nullopt;
  if (!check) {
    return std::nullopt;
  }
  std::uint32_t told = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    told |= std::uint32_t{(*check)[i]} << (8 * i);
  }
  const auto since_ns = told == check_of(*payload) ? take_number(*payload) : std::nullopt;
  // Nor is a block good whose time no clock can show: it would lie before the last one.
  if (!since_ns || *since_ns > static_cast<std::uint64_t>((Instant::max() - last).count())) {
    return std::nullopt;
  }
  block.at = last + Duration{static_cast<std::int64_t>(*since_ns)};
  while (!payload->empty()) {
    const auto record = take_record(*payload);
    if (!record) {
      return std::nullopt;
    }
    block.records.push_back(*record);
  }
  rest = bytes;
  return block;
}

}  // namespace

Result<Journal, std::string> read_journal(ByteView file) {
  const auto magic = take(file, kJournalMagic.size());
  if (!magic || !std::equal(magic->begin(), magic->end(), kJournalMagic.begin())) {
    return Unexpected{std::string{"it does not begin as a journal of this version does"}};
  }
  const auto size = take_number(file);
  const auto robot_file = size ? take(file, *size) : std::nullopt;
  if (!robot_file) {
    return Unexpected{std::string{"it ends in the robot file that it begins with"}};
  }
  Journal journal;
  journal.robot_file.assign(robot_file->begin(), robot_file->end());
  Instant last;
  while (auto block = take_block(file, last)) {
    last = block->at;
    journal.blocks.push_back(std::move(*block));
  }
  journal.bytes_torn = file.size();
  return journal;
}

}  // namespace sensotwin::robot
