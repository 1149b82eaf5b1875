// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "robot/base/epc.hpp"
#include "robot/output/output_file.hpp"

namespace sensotwin::twin {

/// One row that a reader reported of a UHF tag.
struct TagLogRow {
  double time_s{0.0};  ///< when the tag answered; since the start of the run
  robot::Epc epc{};
  std::uint16_t antenna{1};  ///< port, 1 the first
  std::uint16_t channel{1};  ///< ChannelIndex: position in the hop table, 1 the first
  double phase_rad{0.0};     ///< in [0, 2 pi)
  double rssi_dbm{0.0};
  double doppler_hz{0.0};
};

/// CSV with the columns of sllurp, the LLRP client that the data study's logs come from:
///
///     timestamp,reader,antenna,rssi,epc,phase_angle,channel_index,doppler_frequency
///
/// Seconds with microseconds; RSSI in whole dBm, cut as real
/// readers cut it (protocols study, 2.6: -68.5 becomes -68); phase in 4096ths of a turn and Doppler in
/// sixteenths of a hertz, as Impinj's parameters 56 and 68 carry them; EPC as the text of Python bytes. `twin
/// calibrate` reads it back.
class TagLogWriter {
 public:
  /// \param file not yet written to
  explicit TagLogWriter(robot::OutputFile file);

  /// \throws OutputError
  void add(const TagLogRow& row);
  /// \throws OutputError
  void finish() { file_.finish(); }

 private:
  robot::OutputFile file_;
};

}  // namespace sensotwin::twin
