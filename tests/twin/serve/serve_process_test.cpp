// SPDX-License-Identifier: MIT
// `twin serve` as people start it, and clients in another process: this one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "serve_bench.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

using robot::Bytes;
using ::testing::HasSubstr;
using ::testing::Not;

const std::filesystem::path kScenes = std::filesystem::path{SENSOTWIN_SOURCE_DIR} / "scenes";
const std::string kLesson = (kScenes / "lesson_2x2.yaml").string();
const std::string kHallway = (kScenes / "hallway.yaml").string();

/// The value of a key of devices.yaml, without its quotes.
std::string value_of(const std::string& yaml, const std::string& key) {
  const std::size_t at = yaml.find(key + ": \"");
  if (at == std::string::npos) {
    return "";
  }
  const std::size_t begin = at + key.size() + 3;
  return yaml.substr(begin, yaml.find('"', begin) - begin);
}

class ServeProcess : public ::testing::Test {
 protected:
  std::string out() const { return (folder_ / "served").string(); }
  /// Starts it and waits for its wires.
  void start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "serve");
    arguments.insert(arguments.end(), {"--out", out()});
    twin_.emplace(std::move(arguments));
    ASSERT_TRUE(twin_->wait_for(folder_ / "served/devices.yaml"));
    devices_ = content_of(folder_ / "served/devices.yaml");
  }
  TemporaryFolder folder_;
  std::optional<BackgroundTwin> twin_;
  std::string devices_;
};

TEST_F(ServeProcess, OfAMappingSceneOpensTheTerminalsAndNoUhfReader) {
  start({kLesson, "--no-cards"});
  EXPECT_EQ(value_of(devices_, "base"), out() + "/base");
  EXPECT_EQ(value_of(devices_, "sensors"), out() + "/sensors");
  EXPECT_THAT(devices_, Not(HasSubstr("llrp")));
  EXPECT_THAT(devices_, Not(HasSubstr("card_readers")));
}

TEST_F(ServeProcess, StreamsAt15MillisecondsAndStandsStillUntilItIsDriven) {
  start({kLesson, "--no-cards"});
  const PortClient client(value_of(devices_, "base"), B115200);
  client.say({128, 131, 148, 2, 43, 44});
  const auto begun = std::chrono::steady_clock::now();
  Bytes heard;
  while (heard.size() < 40 * 9) {
    const Bytes more = client.hear(1000);
    ASSERT_FALSE(more.empty());
    heard.insert(heard.end(), more.begin(), more.end());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  EXPECT_GT(took.count(), 38 * 0.015) << "40 frames are at least 39 ticks, and the first may be short";
  EXPECT_EQ(heard[0], 19);
  EXPECT_EQ(heard[1], 6);
}

TEST_F(ServeProcess, ReportsTheHeadingTenTimesASecondOfItsOwnTime) {
  start({kLesson, "--no-cards", "--rtf", "10"});
  const PortClient client(value_of(devices_, "sensors"));
  Bytes heard;
  const auto begun = std::chrono::steady_clock::now();
  while (std::ranges::count(heard, '\n') < 50) {
    const Bytes more = client.hear(1000);
    ASSERT_FALSE(more.empty());
    heard.insert(heard.end(), more.begin(), more.end());
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  EXPECT_GT(took.count(), 0.4) << "100 a second of real time";
  EXPECT_THAT(std::string(heard.begin(), heard.end()), HasSubstr("$HCHDM,"));
}

TEST_F(ServeProcess, ServesAReaderWhereThereAreCeilingTags) {
  start({kHallway, "--no-cards", "--llrp", "127.0.0.1:0"});
  const auto at = endpoint_from(value_of(devices_, "llrp"));
  ASSERT_TRUE(at) << devices_;
  const TcpClient client(*at);
  const Bytes greeting = client.hear(1000);
  ASSERT_EQ(greeting.size(), 32u);
  EXPECT_EQ(greeting[1], 63) << "READER_EVENT_NOTIFICATION";
}

TEST_F(ServeProcess, EndsWithinASecondOnCtrlCAndLeavesNoWireThatNobodyAnswers) {
  start({kHallway, "--no-cards", "--llrp", "127.0.0.1:0"});
  const PortClient client(value_of(devices_, "base"));
  client.say({128, 148, 1, 100});
  EXPECT_FALSE(client.hear(1000).empty());
  const auto end = twin_->stop(SIGINT);
  EXPECT_EQ(end.code, 130);
  EXPECT_LT(end.after_s, 1.0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "served/devices.yaml"));
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(folder_ / "served/base")));
  const auto report = nlohmann::json::parse(content_of(folder_ / "served/serve.json"));
  EXPECT_EQ(report["wires"]["base"]["clients"], 1);
  EXPECT_GT(report["sim_s"], 0.0);
}

TEST_F(ServeProcess, EndsBySigtermWithACodeOfItsOwn) {
  start({kLesson, "--no-cards"});
  EXPECT_EQ(twin_->stop(SIGTERM).code, 143);
}

TEST_F(ServeProcess, MayStartAgainInTheSameFolderButNotBesideAnother) {
  start({kLesson, "--no-cards"});
  const Outcome beside = twin("serve " + kLesson + " --no-cards --for 1 --out " + out());
  EXPECT_EQ(beside.code, 73);
  EXPECT_THAT(beside.err, HasSubstr("another twin serve is at work here"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "served/devices.yaml")) << "the first goes on";
  EXPECT_EQ(twin_->stop(SIGKILL).code, -1);
  std::filesystem::remove(folder_ / "served/devices.yaml");  // so that the next one's is not taken for it
  start({kLesson, "--no-cards"});
  const PortClient client(value_of(devices_, "base"));
  client.say({128, 142, 35});
  EXPECT_EQ(client.hear(1000), Bytes{1}) << "the link of a killed one is replaced";
}

TEST_F(ServeProcess, KeepsDrivingWhenItsClientIsGoneAsTheMachineDoes) {
  start({kLesson, "--no-cards"});
  {
    const PortClient client(value_of(devices_, "base"));
    client.say({128, 132, 145, 0, 50, 0, 50});
    client.say({142, 35});
    EXPECT_EQ(client.hear(1000), Bytes{3});
  }
  const PortClient next(value_of(devices_, "base"));
  next.say({142, 41});
  EXPECT_EQ(next.hear(1000), (Bytes{0, 50}));
}

TEST_F(ServeProcess, EndsByItselfWhenItsTimeIsOverAndSaysHowItWent) {
  const Outcome outcome = twin("serve " + kLesson + " --no-cards --rtf 50 --for 5 --json --out " + out());
  EXPECT_EQ(outcome.code, 0);
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_GE(report["sim_s"], 5.0);
  EXPECT_EQ(report["rtf_asked"], 50.0);
  EXPECT_EQ(nlohmann::json::parse(content_of(folder_ / "served/serve.json")), report);
}

TEST_F(ServeProcess, KeepsRealTimeAtMaxWhileNobodyIsThere) {
  const Outcome outcome = twin("serve " + kLesson + " --no-cards --rtf max --for 0.3 --json --out " + out());
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["rtf_asked"], "max");
  EXPECT_LT(report["rtf"], 1.2);
}

TEST_F(ServeProcess, RunsAsFastAsItsClientReadsAtMax) {
  start({kLesson, "--no-cards", "--rtf", "max"});
  const PortClient client(value_of(devices_, "base"));
  client.say({128, 148, 1, 35});
  std::size_t frames = 0;
  const auto begun = std::chrono::steady_clock::now();
  std::chrono::duration<double> took{0.0};
  while (frames < 1000 && took.count() < 5.0) {
    frames += client.hear(1000).size() / 5;
    took = std::chrono::steady_clock::now() - begun;
  }
  EXPECT_GE(frames, 1000u);
  EXPECT_LT(took.count(), 0.5 * 15.0) << "1000 ticks of 15 ms, at twice real time at least";
  RecordProperty("factor", static_cast<int>(15.0 / took.count()));
}

TEST_F(ServeProcess, SaysWhatIsMissingForTheCardsAndServesTheRest) {
  const Outcome outcome = twin("serve " + kLesson + " --vpcd 127.0.0.1:1 --for 0.5 --out " + out());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("apt-get install vsmartcard-vpcd pcscd"));
  EXPECT_THAT(outcome.err, HasSubstr("The other wires are served"));
}

TEST_F(ServeProcess, LetsTheWorldStandStillUntilATagThatLeftWasMissedWhenAskedTo) {
  Endpoint floor;
  const Handle listener = listen_at(floor);
  start({kLesson, "--wait-for-cards", "--vpcd", to_text(floor)});
  const auto accepted = [&] { return Handle{::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK)}; };
  Handle card;
  ASSERT_TRUE(eventually([&] { return static_cast<bool>(card); }, [&] { card = accepted(); }));
  const Bytes tell_atr{0, 1, 4};
  ::send(card.get(), tell_atr.data(), tell_atr.size(), MSG_NOSIGNAL);
  ASSERT_EQ(heard_at(card.get(), 2000).size(), 22u) << "the lesson begins on a tag";

  const PortClient base(value_of(devices_, "base"));
  base.say({128, 131, 148, 1, 35, 145, 0, 200, 0, 200});
  // Off the tag after 8 cm: then no frame comes, though it would every 15 ms.
  ASSERT_TRUE(eventually([&] { return base.hear(200).empty(); }, [] {}));
  card.reset();
  EXPECT_FALSE(base.hear(1000).empty()) << "it was noticed, and time goes on";
}

TEST_F(ServeProcess, RefusesAPortThatIsTaken) {
  Endpoint taken;
  const Handle listener = listen_at(taken);
  const Outcome outcome =
      twin("serve " + kHallway + " --no-cards --for 1 --llrp " + to_text(taken) + " --out " + out());
  EXPECT_EQ(outcome.code, 69);
  EXPECT_THAT(outcome.err, HasSubstr(to_text(taken)));
}

TEST_F(ServeProcess, RefusesWhatIsNoFactorAndNoEndpoint) {
  for (const char* wrong :
       {"--rtf 0", "--rtf -1", "--rtf fast", "--rtf nan", "--llrp nowhere", "--vpcd 1:2:3"}) {
    EXPECT_EQ(twin("serve " + kLesson + " --for 1 " + wrong + " --out " + out()).code, 2) << wrong;
  }
}

}  // namespace
}  // namespace sensotwin::twin
