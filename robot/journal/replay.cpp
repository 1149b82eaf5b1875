// SPDX-License-Identifier: MIT
#include "robot/journal/replay.hpp"

#include <algorithm>
#include <utility>

#include "robot/journal/journal_words.hpp"

namespace sensotwin::robot {

class ReplayWires::ByteEnd : public ByteLink {
 public:
  ByteEnd(ReplayWires& wires, Wire wire) : wires_(wires), wire_(wire) {}

 private:
  bool do_write(ByteView bytes) override {
    return wires_.expect(wire_, WireWord::kWritten, WireWord::kWriteRefused, bytes) == WireWord::kWritten;
  }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    const WireRecord* const next = wires_.next(wire_);
    if (next == nullptr || next->word != WireWord::kRead) {
      return 0;
    }
    if (next->bytes.size() > into.size()) {
      wires_.differ(wire_, "asks for fewer bytes at once");
      return 0;
    }
    const WireRecord record = *wires_.take(wire_, WireWord::kRead);
    std::copy(record.bytes.begin(), record.bytes.end(), into.begin());
    return record.bytes.size();
  }
  [[nodiscard]] bool do_is_up() const override {
    if (wires_.take(wire_, WireWord::kUp)) {
      up_ = true;
    } else if (wires_.take(wire_, WireWord::kDown)) {
      up_ = false;
    }
    return up_;
  }

  ReplayWires& wires_;
  Wire wire_;
  mutable bool up_{false};
};

class ReplayWires::CardEnd : public CardLink {
 public:
  CardEnd(ReplayWires& wires, Wire wire) : wires_(wires), wire_(wire) {}

 private:
  CardPresence do_presence() override {
    for (const CardPresence other : {CardPresence::kNoReader, CardPresence::kEmpty, CardPresence::kPresent}) {
      if (wires_.take(wire_, word_of(other))) {
        presence_ = other;
        break;
      }
    }
    return presence_;
  }
  bool do_begin(ByteView command_apdu) override {
    return wires_.expect(wire_, WireWord::kBegun, WireWord::kBeginRefused, command_apdu) == WireWord::kBegun;
  }
  std::optional<Result<Bytes, CardError>> do_poll() override {
    if (auto answer = wires_.take(wire_, WireWord::kAnswer)) {
      return Result<Bytes, CardError>{std::move(answer->bytes)};
    }
    for (const CardError error : {CardError::kRemoved, CardError::kReaderGone, CardError::kTimeout}) {
      if (wires_.take(wire_, word_of(error))) {
        return Result<Bytes, CardError>{Unexpected{error}};
      }
    }
    return std::nullopt;
  }

  ReplayWires& wires_;
  Wire wire_;
  CardPresence presence_{CardPresence::kNoReader};
};

ReplayWires::ReplayWires() {
  for (std::size_t i = 0; i < kWires; ++i) {
    byte_ends_[i] = std::make_unique<ByteEnd>(*this, static_cast<Wire>(i));
    card_ends_[i] = std::make_unique<CardEnd>(*this, static_cast<Wire>(i));
  }
}

ReplayWires::~ReplayWires() = default;

ByteLink& ReplayWires::bytes(Wire wire) {
  return *byte_ends_[static_cast<std::size_t>(wire)];
}

CardLink& ReplayWires::cards(Wire wire) {
  return *card_ends_[static_cast<std::size_t>(wire)];
}

const WireRecord* ReplayWires::next(Wire wire) const {
  const Script& script = scripts_[static_cast<std::size_t>(wire)];
  return script.empty() ? nullptr : &script.front();
}

std::optional<WireRecord> ReplayWires::take(Wire wire, WireWord word) {
  Script& script = scripts_[static_cast<std::size_t>(wire)];
  if (script.empty() || script.front().word != word) {
    return std::nullopt;
  }
  WireRecord record = std::move(script.front());
  script.pop_front();
  return record;
}

WireWord ReplayWires::expect(Wire wire, WireWord good, WireWord refused, ByteView bytes) {
  const WireRecord* const recorded = next(wire);
  WireRecord said{wire, good, Bytes(bytes.begin(), bytes.end())};
  if (recorded != nullptr && recorded->word == refused) {
    said.word = refused;
  }
  if (recorded == nullptr || *recorded != said) {
    differ(wire, text_of(said));
    return refused;
  }
  outcome_.bytes_compared += bytes.size();
  return take(wire, said.word)->word;
}

void ReplayWires::differ(Wire wire, const std::string& replayed) {
  if (!outcome_.difference) {
    const WireRecord* const recorded = next(wire);
    outcome_.difference = ReplayDifference{
        outcome_.end, recorded != nullptr ? text_of(*recorded) : std::string{name_of(wire)} + ": nothing",
        replayed};
  }
}

ReplayOutcome ReplayWires::run(const Journal& journal, const std::function<void(Instant)>& step,
                               const std::function<void()>& shut_down) {
  outcome_ = {};
  for (const JournalBlock& block : journal.blocks) {
    for (const WireRecord& record : block.records) {
      scripts_[static_cast<std::size_t>(record.wire)].push_back(record);
    }
    outcome_.end = block.at;
    if (block.end) {
      shut_down();
    } else {
      step(block.at);
      ++outcome_.steps;
    }
    for (std::size_t i = 0; i < kWires; ++i) {
      if (!scripts_[i].empty()) {
        differ(static_cast<Wire>(i), std::string{name_of(static_cast<Wire>(i))} + ": nothing");
      }
    }
    if (outcome_.difference) {
      break;
    }
  }
  return outcome_;
}

}  // namespace sensotwin::robot
