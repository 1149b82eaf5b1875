// SPDX-License-Identifier: MIT
#include "twin/output/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <utility>

namespace sensotwin::twin {
namespace {

constexpr double kRedrawPeriod_s = 0.1;  // Chosen: fluent to the eye, nothing to the terminal
constexpr int kBarWidthMin = 10;         // Chosen: below, the numbers alone say more
constexpr int kBarWidthMax = 40;

bool set_and_not_empty(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody calls setenv
  return value != nullptr && *value != '\0';
}

double fraction_of(const ProgressState& state) {
  return state.total > 0.0 ? std::clamp(state.done / state.total, 0.0, 1.0) : 0.0;
}

std::string figures(const ProgressState& state, const std::string& unit) {
  std::string text =
      fmt::format("{:3.0f} %  {:.0f}/{:.0f} {}", 100.0 * fraction_of(state), state.done, state.total, unit);
  if (state.wall_s > 0.0 && state.done > 0.0) {
    const double rate = state.done / state.wall_s;
    text += fmt::format("  {:.3g} {}/s", rate, unit);
    if (state.done < state.total) {
      text += fmt::format("  {} left", duration_text((state.total - state.done) / rate));
    }
  }
  if (!state.note.empty()) {
    text += fmt::format("  {}", state.note);
  }
  return text;
}

}  // namespace

ProgressStyle progress_style_for(int descriptor) {
  ProgressStyle style;
  const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nobody calls setenv
  const bool dumb = terminal == nullptr || std::string_view{terminal} == "dumb";
  style.live = ::isatty(descriptor) == 1 && !dumb && !set_and_not_empty("CI");
  winsize size{};
  if (style.live && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    style.width_columns = size.ws_col;
  }
  return style;
}

Progress::Progress(std::ostream& out, ProgressStyle style, std::string label, std::string unit)
    : out_(out), style_(style), label_(std::move(label)), unit_(std::move(unit)) {}

void Progress::update(const ProgressState& state) {
  if (!style_.live) {
    print_step(state);
  } else if (state.wall_s >= next_draw_s_) {
    next_draw_s_ = state.wall_s + kRedrawPeriod_s;
    draw(state);
  }
}

void Progress::finish(const ProgressState& state) {
  if (!style_.live) {
    print_step(state);
  } else if (drawn_) {
    out_ << "\r\x1b[K" << std::flush;
    drawn_ = false;
  }
}

void Progress::draw(const ProgressState& state) {
  const std::string text = figures(state, unit_);
  // One column stays free: a character in the last one makes some terminals wrap.
  const int room = style_.width_columns - 1;
  std::string line = label_ + " ";
  const int bar_width =
      std::min(kBarWidthMax, room - static_cast<int>(line.size()) - static_cast<int>(text.size()) - 3);
  if (bar_width >= kBarWidthMin) {
    const int full = static_cast<int>(std::floor(fraction_of(state) * bar_width));
    line += "[" + std::string(static_cast<std::size_t>(full), '#') +
            std::string(static_cast<std::size_t>(bar_width - full), '.') + "] ";
  }
  line += text;
  line.resize(std::min(line.size(), static_cast<std::size_t>(std::max(room, 0))));
  out_ << '\r' << line << "\x1b[K" << std::flush;
  drawn_ = true;
}

void Progress::print_step(const ProgressState& state) {
  const int tenths = static_cast<int>(std::floor(fraction_of(state) * 10.0 + 1e-9));
  if (tenths <= tenths_printed_) {
    return;
  }
  tenths_printed_ = tenths;
  out_ << label_ << ": " << figures(state, unit_) << '\n' << std::flush;
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0) {
    return "?";
  }
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace sensotwin::twin
