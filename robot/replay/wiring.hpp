// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/journal/recording_links.hpp"
#include "robot/settings/robot_program.hpp"

namespace sensotwin::robot {

/// The links of a program, with a journal between when there is one. Neither copies nor moves.
class Wiring {
 public:
  /// \param journal  may be null  All must outlive this.
  Wiring(const RobotLinks& links, JournalWriter* journal) : plain_(links) {
    if (journal != nullptr) {
      recorded_.emplace(links, *journal);
    }
  }
  Wiring(const Wiring&) = delete;
  Wiring& operator=(const Wiring&) = delete;

  /// What the program gets.
  [[nodiscard]] RobotLinks links() {
    return recorded_ ? RobotLinks{recorded_->base, recorded_->sensors, recorded_->uhf_reader,
                                  recorded_->floor_reader, recorded_->forward_reader}
                     : plain_;
  }

 private:
  struct Recorded {
    Recorded(const RobotLinks& links, JournalWriter& journal)
        : base(links.base, journal, Wire::kBase),
          sensors(links.sensors, journal, Wire::kSensors),
          uhf_reader(links.uhf_reader, journal, Wire::kUhfReader),
          floor_reader(links.floor_reader, journal, Wire::kFloorReader),
          forward_reader(links.forward_reader, journal, Wire::kForwardReader) {}

    RecordingByteLink base;
    RecordingByteLink sensors;
    RecordingByteLink uhf_reader;
    RecordingCardLink floor_reader;
    RecordingCardLink forward_reader;
  };

  RobotLinks plain_;
  std::optional<Recorded> recorded_;
};

}  // namespace sensotwin::robot
