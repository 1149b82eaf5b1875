// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/base/geometry.hpp"
#include "robot/base/task.hpp"
#include "robot/phase/fuzzy_controller.hpp"
#include "robot/phase/fuzzy_log.hpp"
#include "robot/phase/phase_io.hpp"
#include "robot/phase/phase_pairing.hpp"

namespace sensotwin::robot {

struct FuzzyMissionConfig {
  std::vector<Epc> destinations;  ///< the paper's ordered list of tag IDs
  FuzzySets sets{kReproductionSets};
  PairingConfig pairing;
  double speed_mps{0.2};                         ///< Gueaieb & Miah, section V
  double wheel_base_m{0.235};                    ///< Create 2 Open Interface 2016, packet 20
  double top_wheel_mps{0.5};                     ///< same, opcode 145
  double metres_per_count{kPi * 0.072 / 508.8};  ///< same, packet 43
  double wheel_ratio{1.0};  ///< right wheel's diameter over the left's; metres_per_count is of their mean
  /// Share of the heading still owed (see FuzzyMission) that is made up for in a second. Chosen: frame,
  /// command and acceleration of the wheels take some 50 ms, and a loop through such a delay does not swing
  /// below 1 / (e * 0.05 s) = 7.4.
  double catch_up_per_s{6.0};
  /// No more than this is ever owed. Chosen: four times what 50 ms of the reproduction's 1.1 rad/s leave.
  double most_owed_rad{0.2};
  /// A turn rate holds until the next phase difference, but no longer than this. Chosen: what bridges one
  /// lost reading of two antennas in slots of 100 ms.
  Duration longest_turn{std::chrono::milliseconds{250}};
  /// Without a phase difference for so long, the robot stops. Chosen: 0.4 m of way with the heading kept.
  Duration silence{std::chrono::seconds{2}};
  /// So long it stands and waits for the reader or the tag. Chosen: a reader restarts in less.
  Duration patience{std::chrono::seconds{60}};
  /// A leg that takes longer has failed. Chosen: 60 turns about a tag with a missed floor zone, ten seconds
  /// each (algorithms study, A.2), and the 8 m way there.
  Duration leg_limit{std::chrono::seconds{640}};
};

enum class FuzzyState : std::uint8_t {
  kSteering,        ///< the last phase difference decides
  kKeepingHeading,  ///< none for a while, or none yet: straight on
  kWaiting,         ///< standing, as the tag or the reader is not heard
  kArrived,         ///< at the last destination
  kStopped,         ///< ended before it; the log says why
};

/// For traces and pictures.
struct FuzzyStatus {
  FuzzyState state{FuzzyState::kKeepingHeading};
  std::size_t destination{0};     ///< index in the list; its length when all are reached
  std::optional<PhasePair> pair;  ///< newest of this destination
  double turn_rate_radps{0.0};    ///< asked by the controller, counter-clockwise positive
  double owed_rad{0.0};           ///< asked so far and not yet turned by the wheels
  std::uint64_t decisions{0};     ///< times that the controller has been asked
};

/// The paper's navigation (section IV.C, Figure 6): take the next tag from the list; while its floor tag has
/// not been read, compute the phase difference of that tag and turn by what the fuzzy controller says.
///
/// The controller is asked once for each new phase difference, not once per tick: dtheta = rate * Ts with Ts
/// the time until the next one, driven as a turn rate meanwhile, so that the heading moves by dtheta
/// smoothly. Of several that came in one tick the newest decides.
///
/// Equation 3, theta_new = theta_old + dtheta, speaks of the heading, not of a command: wheels that obey
/// late, accelerate slowly or know speeds in steps only (28.5 mm/s of the Create 2: protocols study, 1.2)
/// turn by something else. So the encoders are asked what was turned, and what is owed is made up for. A base
/// without encoders owes nothing.
///
/// What the paper leaves out is said in FuzzyMissionConfig: silence, a reader that is down, a bump, never
/// arriving. Each of them ends in standing still with an entry in the log.
///
/// Neither copies nor moves: its behaviours hold references into it.
class FuzzyMission {
 public:
  /// \pre no problem_of(config.sets); 0 < speed_mps < top_wheel_mps
  explicit FuzzyMission(const FuzzyMissionConfig& config);
  FuzzyMission(const FuzzyMission&) = delete;
  FuzzyMission& operator=(const FuzzyMission&) = delete;

  /// One control step. \pre sensed.stamp is later than the last one
  /// \returns the command that holds until the next call
  PhaseCommand step(const PhaseSensed& sensed);

  [[nodiscard]] bool done() const {
    return status_.state == FuzzyState::kArrived || status_.state == FuzzyState::kStopped;
  }
  /// All destinations were reached.
  [[nodiscard]] bool arrived() const { return status_.state == FuzzyState::kArrived; }
  [[nodiscard]] const FuzzyStatus& status() const { return status_; }
  [[nodiscard]] const FuzzyController& controller() const { return controller_; }
  [[nodiscard]] FuzzyLog& log() { return log_; }

 private:
  /// What became of waiting, or of a leg.
  enum class End : std::uint8_t { kWell, kFailed };

  Task<> run();
  Task<End> drive_to_destination();
  Task<End> wait_standing(FuzzyEventKind why);
  void listen();
  [[nodiscard]] bool at_destination() const;
  /// What the wheels have turned since the last step is taken off what was asked.
  void count_turn();
  void steer();
  void stand();
  /// Whether this step ends the mission: touched something, or the leg takes too long. Says so.
  [[nodiscard]] bool must_end();
  void say(FuzzyEventKind kind);

  FuzzyMissionConfig config_;
  FuzzyController controller_;
  PhasePairing pairing_;
  FuzzyLog log_;
  FuzzyStatus status_;
  PhaseSensed sensed_;
  std::optional<PhasePair> heard_;  ///< newest phase difference that this step's readings completed
  PhaseCommand command_;
  StepSignal next_;
  std::optional<Instant> last_stamp_;
  Instant leg_begun_;
  Instant heard_at_;  ///< last phase difference of this destination, or when it began to be listened for
  bool started_{false};
  Task<> script_;
};

}  // namespace sensotwin::robot
