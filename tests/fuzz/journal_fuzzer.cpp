// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "robot/journal/journal_bytes.hpp"
#include "robot/journal/journal_reader.hpp"
#include "robot/journal/journal_writer.hpp"
#include "tests/fuzz/fuzzers.hpp"
#include "tests/fuzz/harness.hpp"

namespace sensotwin::fuzz {
namespace {

using robot::Bytes;
using robot::ByteView;

[[nodiscard]] Bytes written(const robot::Journal& journal) {
  Bytes file;
  const auto keep = [&file](ByteView bytes) {
    file.insert(file.end(), bytes.begin(), bytes.end());
    return true;
  };
  robot::JournalWriter writer{keep, journal.robot_file};
  for (const robot::JournalBlock& block : journal.blocks) {
    for (const robot::WireRecord& record : block.records) {
      writer.add(record.wire, record.word, record.bytes);
    }
    block.end ? writer.end_run(block.at) : writer.end_step(block.at);
  }
  return file;
}

[[nodiscard]] bool alike(const robot::JournalBlock& a, const robot::JournalBlock& b) {
  return a.end == b.end && a.at == b.at && a.records == b.records;
}

/// A journal that was read is written to one that reads the same; cut off anywhere, it is as good as its
/// whole blocks.
void file(ByteView input, std::size_t cut) {
  const auto journal = robot::read_journal(input);
  if (!journal) {
    require(!journal.error().empty(), "who refuses a journal says why");
    return;
  }
  require(journal->bytes_torn <= input.size(), "no more is torn than there is");
  robot::Instant last{};
  for (const robot::JournalBlock& block : journal->blocks) {
    require(block.at >= last, "time does not go back");
    last = block.at;
    for (const robot::WireRecord& record : block.records) {
      require(!robot::text_of(record).empty(), "a record can be told");
    }
  }
  const Bytes again = written(*journal);
  const auto second = robot::read_journal(again);
  require(second && second->bytes_torn == 0 && second->robot_file == journal->robot_file &&
              std::ranges::equal(second->blocks, journal->blocks, alike),
          "a journal read, written and read is the same");
  require(written(*second) == again, "a journal is always written alike");

  const auto torn = robot::read_journal(ByteView{again}.first(cut % (again.size() + 1)));
  require(!torn || (torn->blocks.size() <= second->blocks.size() &&
                    std::equal(torn->blocks.begin(), torn->blocks.end(), second->blocks.begin(), alike)),
          "a journal that was cut off is as good as its whole blocks");
}

/// The same bytes as payloads of blocks whose sums are right, so that mutations reach the records.
[[nodiscard]] Bytes with_sums(ByteView input, std::size_t piece) {
  Bytes out(robot::kJournalMagic.begin(), robot::kJournalMagic.end());
  robot::append_number(out, 0);
  for (Script script{input}; !script.empty();) {
    const ByteView payload = script.bytes(piece);
    out.push_back(payload.front() % 2 == 0 ? 'T' : 'E');
    robot::append_number(out, payload.size());
    out.insert(out.end(), payload.begin(), payload.end());
    const std::uint32_t check = robot::check_of(payload);
    for (int shift = 0; shift < 32; shift += 8) {
      out.push_back(static_cast<std::uint8_t>(check >> shift));
    }
  }
  return out;
}

}  // namespace

void journal(ByteView input) {
  Script script{input};
  const std::size_t piece = 1u + script.byte();
  file(script.rest(), 7 * piece);
  file(with_sums(script.rest(), piece), 11 * piece);
}

}  // namespace sensotwin::fuzz
