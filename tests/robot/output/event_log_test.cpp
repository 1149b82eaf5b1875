// SPDX-License-Identifier: MIT
#include "robot/output/event_log.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "robot/output/output_file.hpp"
#include "robot/output/text_format.hpp"
#include "tests/robot/output/temporary_folder.hpp"

namespace sensotwin::robot {
namespace {

TEST(EventLog, PutsTimeFirstAndKeysInTheOrderGiven) {
  const TemporaryFolder folder;
  EventLog log(OutputFile(folder / "events.jsonl"));
  log.add(
      Instant{from_s(1.5)}, "tag_found",
      {{"uid", uid_text(0xE004010012345678u)}, {"column", 3}, {"row", -1}, {"x_m", 1.524}, {"new", true}});
  log.add(Instant{from_s(2.0)}, "bump");
  log.finish();
  EXPECT_EQ(
      content_of(folder / "events.jsonl"),
      R"({"t_s":1.500,"event":"tag_found","uid":"E004010012345678","column":3,"row":-1,"x_m":1.524,"new":true})"
      "\n"
      R"({"t_s":2.000,"event":"bump"})"
      "\n");
  EXPECT_EQ(log.count(), 2);
}

TEST(EventLog, WritesNullForNotANumberBecauseJsonHasNone) {
  const TemporaryFolder folder;
  EventLog log(OutputFile(folder / "events.jsonl"));
  log.add(Instant{}, "odd",
          {{"a", std::numeric_limits<double>::quiet_NaN()}, {"b", 2.0}, {"c", -0.0}, {"d", 0.25}});
  log.finish();
  EXPECT_EQ(content_of(folder / "events.jsonl"),
            "{\"t_s\":0.000,\"event\":\"odd\",\"a\":null,\"b\":2,\"c\":0,\"d\":0.25}\n");
}

}  // namespace
}  // namespace sensotwin::robot
