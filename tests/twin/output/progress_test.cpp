// SPDX-License-Identifier: MIT
#include "twin/output/progress.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <sstream>

namespace sensotwin::twin {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string last_frame(const std::string& text) {
  return text.substr(text.rfind('\r') + 1);
}

TEST(Progress, PrintsOneLineForEachTenthWhereThereIsNoTerminal) {
  std::ostringstream out;
  Progress progress(out, {.live = false}, "map", "tiles");
  for (int done = 0; done <= 207; ++done) {
    progress.update({.done = static_cast<double>(done), .total = 207.0, .wall_s = 0.01 * done});
  }
  progress.finish({.done = 207.0, .total = 207.0, .wall_s = 2.07});
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, HasSubstr("map:  50 %  104/207 tiles  100 tiles/s  1 s left\n"));
  EXPECT_THAT(text, HasSubstr("map: 100 %  207/207 tiles  100 tiles/s\n"));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST(Progress, DrawsABarWithRateAndTimeLeftOnATerminal) {
  std::ostringstream out;
  Progress progress(out, {.live = true, .width_columns = 100}, "map", "tiles");
  progress.update({.done = 50.0, .total = 200.0, .wall_s = 10.0, .note = "1240 x real time"});
  const std::string frame = last_frame(out.str());
  EXPECT_THAT(frame, HasSubstr("[#"));
  EXPECT_THAT(frame, HasSubstr(".] "));
  EXPECT_THAT(frame, HasSubstr(" 25 %  50/200 tiles  5 tiles/s  30 s left  1240 x real time"));
}

TEST(Progress, NeverDrawsBeyondTheWidthOfTheTerminal) {
  for (const int width : {1, 10, 30, 60, 80, 200}) {
    std::ostringstream out;
    Progress progress(out, {.live = true, .width_columns = width}, "map", "tiles");
    progress.update({.done = 50.0, .total = 200.0, .wall_s = 10.0, .note = "1240 x real time"});
    const std::string frame = last_frame(out.str());
    EXPECT_LT(frame.size() - std::string("\x1b[K").size(), static_cast<std::size_t>(width)) << width;
  }
}

TEST(Progress, RedrawsAtMostTenTimesASecond) {
  std::ostringstream out;
  Progress progress(out, {.live = true}, "map", "tiles");
  for (int i = 0; i < 1000; ++i) {
    progress.update({.done = static_cast<double>(i), .total = 1000.0, .wall_s = 0.001 * i});
  }
  const std::string text = out.str();
  EXPECT_LE(std::count(text.begin(), text.end(), '\r'), 10);
}

TEST(Progress, RemovesTheBarWhenFinished) {
  std::ostringstream out;
  Progress progress(out, {.live = true}, "map", "tiles");
  progress.update({.done = 1.0, .total = 2.0, .wall_s = 1.0});
  progress.finish({.done = 2.0, .total = 2.0, .wall_s = 2.0});
  EXPECT_TRUE(out.str().ends_with("\r\x1b[K"));
}

TEST(Progress, SurvivesAJobOfNothing) {
  std::ostringstream out;
  Progress progress(out, {.live = false}, "map", "tiles");
  progress.update({.done = 0.0, .total = 0.0});
  progress.finish({.done = 0.0, .total = 0.0});
  EXPECT_EQ(out.str(), "");
}

TEST(DurationText, SpeaksOfWhatMattersToAPerson) {
  EXPECT_EQ(duration_text(41.2), "41 s");
  EXPECT_EQ(duration_text(185.0), "3 min 05 s");
  EXPECT_EQ(duration_text(7800.0), "2 h 10 min");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "?");
}

TEST(ProgressStyle, IsNotLiveOnAPipe) {
  EXPECT_FALSE(progress_style_for(-1).live);
}

}  // namespace
}  // namespace sensotwin::twin
