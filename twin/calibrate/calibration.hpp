// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "twin/calibrate/hop_table.hpp"
#include "twin/calibrate/noise_fit.hpp"
#include "twin/calibrate/reader_timing.hpp"
#include "twin/calibrate/tag_links.hpp"

namespace sensotwin::twin {

/// What is known beforehand of the logs' reader.
struct CalibrationSettings {
  Band band;
  /// Which way phase goes with distance, unless a hop table is given, which tells it. Default: falls (data
  /// study, 3.2).
  double phase_sign{-1.0};
  int starts{200};     ///< of the search for the hop table. Chosen: see docs/calibrate.md
  int resamples{200};  ///< of each bootstrap. Chosen: the ends of a 95 % interval to a tenth of its width
  std::uint64_t seed{1};
};

struct CalibrationInput {
  std::vector<TagLog> logs;                        ///< of one reader with one hop table, tags at rest
  std::vector<std::optional<double>> distance_m;   ///< antenna to tag, of each log where known
  std::optional<std::vector<double>> channels_hz;  ///< the hop table, if the reader published it
};

/// One link's phase against frequency.
struct LinkLine {
  std::size_t link{0};
  int channels{0};
  bool strong{false};  ///< fit to find a hop table from, and judged: see kStrong_dbm
  FrequencyLine line;
};

/// Mean RSSI above which a link is strong: its phases are linear in frequency (data study, 3.1).
inline constexpr double kStrong_dbm = -60.0;

struct RssiLawFit {
  Estimate at_1m_dbm;
  Estimate slope_db;  ///< per decade
};

/// All that logs say of a reader.
struct Calibration {
  CalibrationSettings settings;
  std::vector<std::string> logs;
  std::size_t reads{0};
  std::size_t stale_channels{0};  ///< rows of accumulating reports whose channel was set right
  std::vector<TagLink> links;
  NoiseFit noise;
  FlipFit flips;
  std::optional<DopplerFit> doppler;
  std::optional<HopTable> recovered;  ///< when none was given
  std::vector<double> channels_hz;    ///< given or recovered; empty: neither
  double phase_sign{-1.0};
  /// Mean coherence of strong links with phase rising and falling, when the hop table was given.
  std::optional<double> rising_coherence;
  std::optional<double> falling_coherence;
  std::vector<LinkLine> lines;
  std::optional<Estimate> strong_coherence;  ///< mean over strong links
  double linear_share{0.0};                  ///< of strong links, coherence over 0.95
  /// Delay of port, cable and way there and back, mean over the strong links of each port; and less the way,
  /// where distances are known.
  std::map<int, Estimate> delay_s;
  std::map<int, Estimate> cable_delay_s;
  std::vector<ReaderTiming> timings;
  int phase_steps{4096};    ///< per turn: the coarsest that nine tenths of all phases keep to
  double weakest_dbm{0.0};  ///< one read in a hundred is weaker
  std::optional<RssiLawFit> rssi;
};

/// Fits everything. Deterministic in settings.seed; the order of logs matters to the last digits only.
/// \param go_on  asked often; false ends the work. \returns nothing then
/// \throws SceneError for a channel beyond the band
[[nodiscard]] std::optional<Calibration> calibrate(CalibrationInput input,
                                                   const CalibrationSettings& settings,
                                                   const std::function<bool()>& go_on);

[[nodiscard]] std::string to_json(const Calibration& calibration);
[[nodiscard]] std::string to_table(const Calibration& calibration);
/// A `radio:` section with what was found, keys as in world::RadioDescription, for scenes to use.
[[nodiscard]] std::string to_profile(const Calibration& calibration);

}  // namespace sensotwin::twin
