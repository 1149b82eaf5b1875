// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "robot/hal/byte_link.hpp"
#include "robot/hal/card_link.hpp"
#include "robot/journal/journal_format.hpp"

namespace sensotwin::robot {

/// Where a program went another way than the one that the journal tells of.
struct ReplayDifference {
  Instant at;
  std::string recorded;  ///< what the journal has next on that wire
  std::string replayed;  ///< what the program did instead
};

struct ReplayOutcome {
  std::size_t steps{0};
  Instant end;                    ///< of the last step replayed
  std::size_t bytes_compared{0};  ///< written, and commands to cards
  std::optional<ReplayDifference> difference;
};

/// The far ends of the wires, which say again what a journal has, and compare what they are told.
class ReplayWires {
 public:
  ReplayWires();
  ~ReplayWires();
  ReplayWires(const ReplayWires&) = delete;
  ReplayWires& operator=(const ReplayWires&) = delete;

  [[nodiscard]] ByteLink& bytes(Wire wire);
  [[nodiscard]] CardLink& cards(Wire wire);

  /// Runs the program along the journal until its end or the first difference.
  /// \param step      one step of the program that has the wires
  /// \param shut_down what ends it
  [[nodiscard]] ReplayOutcome run(const Journal& journal, const std::function<void(Instant)>& step,
                                  const std::function<void()>& shut_down);

 private:
  class ByteEnd;
  class CardEnd;
  /// What is to come on one wire in this step.
  using Script = std::deque<WireRecord>;

  [[nodiscard]] const WireRecord* next(Wire wire) const;
  /// The next record of the wire, taken, when its word is this one.
  [[nodiscard]] std::optional<WireRecord> take(Wire wire, WireWord word);
  /// What the program said: as recorded, or the first difference. \returns the record's word
  [[nodiscard]] WireWord expect(Wire wire, WireWord good, WireWord refused, ByteView bytes);
  void differ(Wire wire, const std::string& replayed);

  std::array<Script, kWires> scripts_;
  std::array<std::unique_ptr<ByteEnd>, kWires> byte_ends_;
  std::array<std::unique_ptr<CardEnd>, kWires> card_ends_;
  ReplayOutcome outcome_;
};

}  // namespace sensotwin::robot
