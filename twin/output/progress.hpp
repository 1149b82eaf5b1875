// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace sensotwin::twin {

/// How to talk to whoever reads stderr.
struct ProgressStyle {
  bool live{false};       ///< a bar that redraws itself; else one line for every 10 %
  int width_columns{80};  ///< of the terminal
};

/// Live only when `descriptor` is a terminal, TERM is not "dumb" and CI is not set; asks the terminal's
/// width.
[[nodiscard]] ProgressStyle progress_style_for(int descriptor);

/// How far a job is.
struct ProgressState {
  double done{0.0};
  double total{1.0};
  double wall_s{0.0};       ///< since the job began; main's clock, so that nobody below main reads one
  std::string_view note{};  ///< a few words at the end of the bar, for instance "1240 x real time"
};

/// Progress bar with rate and time left.
class Progress {
 public:
  /// \param out  stderr; must outlive this  \param label  what is being done  \param unit  plural: "tiles"
  Progress(std::ostream& out, ProgressStyle style, std::string label, std::string unit);

  /// Call as often as you like: the bar redraws at most ten times a second, a line appears once per 10 %.
  void update(const ProgressState& state);
  /// Removes the bar, or completes the lines; the caller's next output begins on an empty line.
  void finish(const ProgressState& state);

 private:
  void draw(const ProgressState& state);
  void print_step(const ProgressState& state);

  std::ostream& out_;
  ProgressStyle style_;
  std::string label_;
  std::string unit_;
  double next_draw_s_{0.0};
  int tenths_printed_{0};
  bool drawn_{false};
};

/// "41 s", "3 min 05 s", "2 h 10 min": what a person wants to know of a duration. "?" when not finite.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace sensotwin::twin
