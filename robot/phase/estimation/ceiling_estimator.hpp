// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/phase/estimation/joint_filter.hpp"
#include "robot/phase/estimation/tag_bank.hpp"
#include "robot/phase/phase_io.hpp"

namespace sensotwin::robot {

/// A tag as the robot is told of it: its code, and about how high it hangs. Not where.
struct ListedTag {
  Epc epc;
  double height_m{3.0};
};

/// All that the estimator is told.
struct EstimatorConfig {
  PhaseReaderModel reader;
  WheelModel wheels;
  CompassTrust compass;
  double height_sigma_m{0.03};  ///< of ListedTag::height_m. Chosen: a ceiling measured by tape
  double gate_sigmas{5.0};      ///< algorithms study, A.4
  /// A tag whose squared innovations over their variance average more than this is dropped and sought anew
  /// (A.4: 3 over phase differences; ours count each port).
  double misfit_limit{4.0};
  /// The noise is learned from successive innovations, between the model's and this many times it.
  double most_noise_scale{5.0};
  /// The model's echoes are taken for this many times as large: above 1 where they are known to come from a
  /// few directions. One from the tag's own direction then bends phases the same way for a metre, which no
  /// Gauss-Markov process does.
  double echo_caution{1.0};
  double floor_radius_m{0.05};  ///< of the floor antenna's zone, if there are floor tags
  std::size_t banks{6};         ///< tags sought at once. Chosen: more are never ahead of a path
  bool check_wiring{true};      ///< look for exchanged cables of ports 1 and 2
};

enum class TagKnowledge : std::uint8_t {
  kUnheard,
  kSought,   ///< heard; where it is is a Gaussian sum
  kTracked,  ///< part of the joint filter
  kKept,     ///< was tracked; set aside because there is no room
};

/// Where the robot thinks a tag is. Frame: M.
struct TagEstimate {
  TagKnowledge knowledge{TagKnowledge::kUnheard};
  Vec2 p_M_m{0.0, 0.0};
  Eigen::Matrix2d covariance_m2{Eigen::Matrix2d::Zero()};
  double height_m{3.0};
  std::optional<Instant> heard;
};

enum class EstimatorEventKind : std::uint8_t {
  kTagFound,       ///< a tag's place is known now
  kTagLost,        ///< was known to a hand; its reads do not fit that any more: sought anew
  kTagMoved,       ///< found again elsewhere
  kCablesSwapped,  ///< ports 1 and 2 are exchanged; taken into account from now on
  kWiringAsGiven,  ///< they are not
  kWiringDoubted,  ///< too many tags were dropped since they were taken for exchanged: all is sought anew
};

struct EstimatorEvent {
  Instant stamp;
  EstimatorEventKind kind{EstimatorEventKind::kTagFound};
  int tag{-1};             ///< index in the list
  double distance_m{0.0};  ///< kTagMoved: how far
};

/// Where the ceiling tags are and where the robot is, from encoder counts, phases and, if there are, compass
/// and floor tags; nothing is known of the tags' places before (algorithms study, A.4).
///
/// A tag newly heard gets a Gaussian sum (TagBank); settled, it joins the filter (JointFilter). Each read is
/// used where the antenna was when it was made. Frame M: where the robot stood at the start.
class CeilingEstimator {
 public:
  CeilingEstimator(const EstimatorConfig& config, std::vector<ListedTag> tags);
  CeilingEstimator(const CeilingEstimator&) = delete;
  CeilingEstimator& operator=(const CeilingEstimator&) = delete;

  /// Which tags are sought and used, by index in the list; others' reads are passed over.
  void attend(std::span<const int> tags);
  /// One control step. \pre sensed.stamp is later than the last one
  void step(const PhaseSensed& sensed);
  /// What is known of a tag's place is wrong: its next reads tell it anew.
  void seek_anew(int tag);

  [[nodiscard]] Pose2 pose() const { return filter_.pose(); }
  [[nodiscard]] Eigen::Matrix3d pose_covariance() const { return filter_.pose_covariance(); }
  [[nodiscard]] TagEstimate tag(int id) const;
  [[nodiscard]] int tags() const { return static_cast<int>(listed_.size()); }
  /// Of the robot beside the line from one tag to another (either may be -1: exactly known).
  [[nodiscard]] double across_sigma_m(const Vec2& n_M, int from, int to, double part) const {
    return filter_.across_sigma_m(n_M, from, to, part);
  }
  /// Last read of any listed tag.
  [[nodiscard]] std::optional<Instant> heard() const { return heard_; }
  [[nodiscard]] double noise_scale() const { return std::sqrt(noise_scale2_); }
  [[nodiscard]] bool cables_swapped() const { return swapped_; }
  /// Events since they were last taken, at most kMostEvents.
  [[nodiscard]] std::span<const EstimatorEvent> events() const { return events_; }
  void forget_events() { events_.clear(); }
  [[nodiscard]] const JointFilter& filter() const { return filter_; }
  /// Tags dropped for misfit since the start.
  [[nodiscard]] int drops() const { return drops_; }

 private:
  static constexpr std::size_t kMostEvents = 64;
  struct Watched {
    bool attended{true};
    int bank{-1};
    double misfit{1.0};
    int rejected_in_a_row{0};
    int offsets_in_a_row{0};
    std::optional<Instant> heard;
    std::array<double, PhaseReaderModel::kMostAntennas> last_innovation{};
    std::array<double, PhaseReaderModel::kMostAntennas> way_at_innovation_m{};
    std::array<double, PhaseReaderModel::kMostAntennas> hz_at_innovation{};
    std::array<bool, PhaseReaderModel::kMostAntennas> has_innovation{};
    bool certain{false};  ///< its place was once known well
    bool was_known{false};
    Eigen::Vector3d last_M_m{0.0, 0.0, 0.0};
    Eigen::Matrix3d last_covariance{Eigen::Matrix3d::Zero()};
    bool kept{false};
  };
  [[nodiscard]] std::optional<int> index_of(const Epc& epc) const;
  void use(const UhfRead& read);
  void seek(int id, const UhfRead& read, const Pose2& X_OR_then);
  void track(int id, const UhfRead& read, const Pose2& X_now_then);
  void become_certain(int id);
  void learn_noise(Watched& tag, const UhfRead& read, const JointFilter::Outcome& outcome);
  void promote(int id);
  void drop(int id);
  void release_bank(int id);
  bool make_room(int wanted);
  void watch_wiring();
  void judge_wiring();
  void doubt_wiring();
  void reopen_wiring();
  void exchange_mounts();
  void fix_on_floor_tag(const Epc& epc);
  void say(EstimatorEventKind kind, int tag, double distance_m = 0.0);

  EstimatorConfig config_;
  std::vector<ListedTag> listed_;
  std::vector<int> by_epc_;  ///< indices of listed_, in order of EPC
  std::vector<Watched> watched_;
  DeadReckoning reckoning_;
  JointFilter filter_;
  std::vector<TagBank> banks_;
  std::vector<int> bank_owner_;
  std::vector<EstimatorEvent> events_;
  Instant now_;
  std::optional<Instant> heard_;
  double noise_scale2_{1.0};
  double way_m_{0.0};  ///< of an antenna, since the start
  bool wiring_known_{false};
  bool swapped_{false};
  double settled_evidence_{0.0};  ///< for exchanged cables, of banks that were let go
  double wiring_doubt_{0.0};      ///< tags dropped of late
  double doubted_at_m_{0.0};      ///< way_m_ at the last of them
  int drops_{0};
};

}  // namespace sensotwin::robot
