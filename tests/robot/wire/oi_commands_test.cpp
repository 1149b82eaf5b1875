// SPDX-License-Identifier: MIT
#include "robot/wire/oi_commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "robot/base/random.hpp"

namespace sensotwin::robot::oi {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Decoded {
  std::vector<Command> commands;
  std::vector<CommandError> errors;
};

[[nodiscard]] Decoded decode(ByteView bytes, const OpcodeTable& table = kOpenInterface) {
  Decoded out;
  CommandDecoder decoder{table};
  for (const std::uint8_t byte : bytes) {
    if (const auto result = decoder.push(byte)) {
      if (*result) {
        out.commands.push_back(**result);
      } else {
        out.errors.push_back(result->error());
      }
    }
  }
  return out;
}

/// One command of each opcode, with values that tell every data byte from its neighbours.
[[nodiscard]] std::vector<Command> one_of_each() {
  Schedule schedule{.days = 40};
  schedule.times[3] = {15, 0};
  schedule.times[5] = {10, 36};
  Song song{.number = 2, .length = 2};
  song.notes[0] = {69, 16};
  song.notes[1] = {72, 32};
  return {Reset{},
          Start{},
          Baud{10},
          Control{},
          Safe{},
          Full{},
          Power{},
          Spot{},
          Clean{},
          Max{},
          Drive{-200, 500},
          Motors{13},
          Leds{4, 1, 128},
          song,
          Play{3},
          Sensors{100},
          SeekDock{},
          PwmMotors{-55, -25, 25},
          DriveDirect{200, -197},
          DrivePwm{-255, 51},
          Stream{Bytes{29, 13}},
          QueryList{Bytes{7, 13}},
          PauseResume{1},
          SchedulingLeds{65, 3},
          DigitLedsRaw{{1, 2, 4, 8}},
          DigitLedsAscii{{'A', 'B', 'C', 'D'}},
          Buttons{4},
          schedule,
          SetDayTime{1, 12, 30},
          Stop{}};
}

TEST(Command, ReturnsFromTheWireAsItWasForEveryOpcode) {
  const std::vector<Command> all = one_of_each();
  ASSERT_EQ(all.size(), std::variant_size_v<Command>);
  for (const Command& command : all) {
    const Bytes bytes = encode(command);
    EXPECT_EQ(bytes.front(), static_cast<std::uint8_t>(opcode_of(command)));
    const Decoded decoded = decode(bytes);
    EXPECT_THAT(decoded.errors, IsEmpty());
    EXPECT_THAT(decoded.commands, ElementsAre(command)) << "opcode " << int{bytes.front()};
  }
}

TEST(Command, FollowsOneAnotherWithoutGapsInOneStreamOfBytes) {
  Bytes bytes;
  for (const Command& command : one_of_each()) {
    const Bytes one = encode(command);
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  EXPECT_EQ(decode(bytes).commands, one_of_each());
}

// Worked examples of the Create 2 Open Interface (2016), pages 12 to 21.
TEST(Command, EncodesTheWorkedExamplesOfTheManual) {
  EXPECT_THAT(encode(Drive{-200, 500}), ElementsAre(137, 255, 56, 1, 244));
  EXPECT_THAT(encode(Motors{Motors::kSideBrush | Motors::kMainBrush | Motors::kSideBrushClockwise}),
              ElementsAre(138, 13));
  EXPECT_THAT(encode(Leds{.bits = 4, .color = 0, .intensity = 128}), ElementsAre(139, 4, 0, 128));
  EXPECT_THAT(encode(DigitLedsAscii{{'A', 'B', 'C', 'D'}}), ElementsAre(164, 65, 66, 67, 68));
  EXPECT_THAT(encode(QueryList{Bytes{7, 13}}), ElementsAre(149, 2, 7, 13));
  EXPECT_THAT(encode(Stream{Bytes{29, 13}}), ElementsAre(148, 2, 29, 13));
  Schedule schedule{.days = 40};  // Wednesday 8 and Friday 32
  schedule.times[3] = {15, 0};
  schedule.times[5] = {10, 36};
  EXPECT_THAT(encode(schedule), ElementsAre(167, 40, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 10, 36, 0, 0));
}

TEST(Command, SendsTheRightWheelFirst) {
  EXPECT_THAT(encode(DriveDirect{.right_mm_s = 200, .left_mm_s = -200}), ElementsAre(145, 0, 200, 255, 56));
}

TEST(Command, KnowsWhetherItsValuesAreAllowed) {
  for (const Command& command : one_of_each()) {
    EXPECT_TRUE(in_range(command)) << static_cast<int>(opcode_of(command));
  }
  EXPECT_TRUE(in_range(Drive{500, kStraight}));
  EXPECT_TRUE(in_range(Drive{500, kStraightToo}));
  EXPECT_FALSE(in_range(Drive{501, kStraight}));
  EXPECT_FALSE(in_range(Drive{500, 2001}));
  EXPECT_FALSE(in_range(DrivePwm{0, -256}));
  EXPECT_FALSE(in_range(Song{.number = 0, .length = 0}));
  EXPECT_FALSE(in_range(DigitLedsAscii{{'A', 31, 'A', 'A'}}));
}

TEST(Command, ClampsToWhatIsAllowedAndLeavesSpecialRadiiAlone) {
  EXPECT_EQ(clamped(Drive{900, 32766}), Command(Drive{500, 2000}));
  EXPECT_EQ(clamped(Drive{-900, kStraight}), Command(Drive{-500, kStraight}));
  EXPECT_EQ(clamped(DriveDirect{-501, 501}), Command(DriveDirect{-500, 500}));
}

TEST(Command, SaysThatItDoesNotFit) {
  std::array<std::uint8_t, 4> four{};
  const auto result = encode(DriveDirect{1, 1}, four);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error(), CommandError::kNoRoom);
}

TEST(CommandDecoder, SkipsOneByteOfAnUnknownOpcode) {
  const Decoded decoded = decode(Bytes{147, 0, 128});
  EXPECT_THAT(decoded.errors, ElementsAre(CommandError::kUnknownOpcode, CommandError::kUnknownOpcode));
  EXPECT_THAT(decoded.commands, ElementsAre(Command(Start{})));
}

TEST(CommandDecoder, WaitsForMissingDataBytesAndTakesACommandForThem) {
  // A lost byte makes the robot eat the next opcode: 137 0 200 [0] 1, then 128.
  const Decoded decoded = decode(Bytes{137, 0, 200, 1, 128, 131});
  EXPECT_THAT(decoded.commands, ElementsAre(Command(Drive{200, 384}), Command(Safe{})));
}

TEST(CommandDecoder, CompletesASongOfNoNotes) {
  EXPECT_THAT(decode(Bytes{140, 1, 0, 128}).commands,
              ElementsAre(Command(Song{.number = 1, .length = 0}), Command(Start{})));
}

TEST(CommandDecoder, ConsumesASongThatIsTooLongAndGoesOn) {
  Bytes bytes{140, 0, 17};
  bytes.resize(bytes.size() + 34, 128);
  bytes.push_back(131);
  const Decoded decoded = decode(bytes);
  EXPECT_THAT(decoded.errors, ElementsAre(CommandError::kSongTooLong));
  EXPECT_THAT(decoded.commands, ElementsAre(Command(Safe{})));
}

TEST(CommandDecoder, EndsAStreamByAnEmptyList) {
  EXPECT_THAT(decode(Bytes{148, 0}).commands, ElementsAre(Command(Stream{})));
}

TEST(CommandDecoder, KnowsNoDriveDirectOnARoomba400) {
  const Decoded decoded = decode(Bytes{145, 128}, kSerialCommandInterface);
  EXPECT_THAT(decoded.errors, ElementsAre(CommandError::kUnknownOpcode));
  EXPECT_THAT(decoded.commands, ElementsAre(Command(Start{})));
}

TEST(CommandDecoder, NeverCrashesOnAMillionRandomBytes) {
  RandomStream random = RandomStream{1}.fork("command bytes");
  for (const OpcodeTable* table : {&kOpenInterface, &kSerialCommandInterface}) {
    CommandDecoder decoder{*table};
    std::size_t commands = 0;
    for (int i = 0; i < 500'000; ++i) {
      const auto result = decoder.push(static_cast<std::uint8_t>(random.below(256)));
      if (result && *result) {
        ++commands;
        static_cast<void>(in_range(**result));
        EXPECT_EQ(decode(encode(**result), *table).commands.size(), 1u);
      }
    }
    EXPECT_GT(commands, 1000u);
  }
}

RC_GTEST_PROP(Command, DrivesSurviveTheWireWhateverTheirValues, (std::int16_t a, std::int16_t b)) {
  for (const Command& command : {Command(Drive{a, b}), Command(DriveDirect{a, b}), Command(DrivePwm{a, b})}) {
    RC_ASSERT(decode(encode(command)).commands == std::vector{command});
    RC_ASSERT(in_range(clamped(command)));
  }
}

RC_GTEST_PROP(Command, ListsSurviveTheWireWhateverTheirLength, (std::vector<std::uint8_t> ids)) {
  ids.resize(std::min<std::size_t>(ids.size(), 255));
  for (const Command& command : {Command(Stream{ids}), Command(QueryList{ids})}) {
    RC_ASSERT(decode(encode(command)).commands == std::vector{command});
  }
}

}  // namespace
}  // namespace sensotwin::robot::oi
