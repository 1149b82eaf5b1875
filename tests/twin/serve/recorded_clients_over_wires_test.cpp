// SPDX-License-Identifier: MIT
// What pycreate2, libcreate and sllurp sent (recorded beside the repository, ../shared/vectors), said again
// to `twin serve` in another process, by terminal and TCP.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "robot/wire/llrp/codec.hpp"
#include "robot/wire/llrp/frame.hpp"
#include "serve_bench.hpp"
#include "tests/robot/output/temporary_folder.hpp"
#include "twin_process.hpp"

namespace sensotwin::twin {
namespace {

namespace fs = std::filesystem;
namespace llrp = robot::llrp;
using robot::Bytes;

const fs::path kSource{SENSOTWIN_SOURCE_DIR};
const fs::path kVectors = kSource / "../shared/vectors";

/// `seconds > name decimals`, of a client that spoke; other lines are left out.
struct Said {
  double at_s{0.0};
  Bytes bytes;
};
std::vector<Said> said_in(const fs::path& session) {
  std::ifstream file{session};
  std::vector<Said> all;
  for (std::string text; std::getline(file, text);) {
    std::istringstream words{text};
    Said said;
    char kind = ' ';
    if (text.starts_with('#') || !(words >> said.at_s >> kind) || kind != '>') {
      continue;
    }
    for (std::string word; words >> word;) {
      if (std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
        said.bytes.push_back(static_cast<std::uint8_t>(std::stoi(word)));
      }
    }
    all.push_back(std::move(said));
  }
  return all;
}

class RecordedClients : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kVectors)) {
      GTEST_SKIP() << "no recorded vectors at " << kVectors;
    }
  }
  void serve(const std::string& scene) {
    twin_.emplace(std::vector<std::string>{"serve", (kSource / "scenes" / scene).string(), "--no-cards",
                                           "--llrp", "127.0.0.1:0", "--out", (folder_ / "served").string()});
    ASSERT_TRUE(twin_->wait_for(folder_ / "served/devices.yaml"));
  }
  /// Says a session as fast as it was said, pauses of more than a tenth of a second shortened to that.
  /// \returns what was heard after each word
  std::vector<Bytes> say(const std::string& client) {
    const PortClient port(folder_ / "served/base", B115200);
    std::vector<Bytes> heard;
    double last_s = 0.0;
    for (const Said& said : said_in(kVectors / "oi" / (client + ".session.txt"))) {
      ::poll(nullptr, 0, static_cast<int>(1e3 * std::clamp(said.at_s - last_s, 0.0, 0.1)));
      last_s = said.at_s;
      if (!heard.empty()) {
        const Bytes late = port.hear();
        heard.back().insert(heard.back().end(), late.begin(), late.end());
      }
      EXPECT_EQ(port.say(said.bytes), said.bytes.size());
      const bool asks = said.bytes.front() == 142 || said.bytes.front() == 149;
      heard.push_back(port.hear(asks ? 500 : 0));
    }
    return heard;
  }

  TemporaryFolder folder_;
  std::optional<BackgroundTwin> twin_;
};

TEST_F(RecordedClients, Pycreate2Gets80BytesForEachOfItsQuestions) {
  serve("lesson_2x2.yaml");
  std::size_t answers = 0;
  for (const Bytes& bytes : say("pycreate2")) {
    EXPECT_EQ(bytes.size() % 80, 0u);
    answers += bytes.size() / 80;
  }
  EXPECT_EQ(answers, 3u);
}

TEST_F(RecordedClients, LibcreateGetsItsStreamOf75ByteFrames) {
  serve("lesson_2x2.yaml");
  Bytes all;
  for (const Bytes& bytes : say("libcreate_create2")) {
    all.insert(all.end(), bytes.begin(), bytes.end());
  }
  std::size_t frames = 0;
  for (std::size_t at = 0; at + 75 <= all.size(); at += 75, ++frames) {
    ASSERT_EQ(all[at], 19) << "frame " << frames;
    ASSERT_EQ(all[at + 1], 72) << "frame " << frames;
    std::uint8_t sum = 0;
    for (std::size_t i = 0; i < 75; ++i) {
      sum = static_cast<std::uint8_t>(sum + all[at + i]);
    }
    ASSERT_EQ(sum, 0) << "frame " << frames;
  }
  EXPECT_GT(frames, 30u);
}

/// One recorded LLRP client after the other's requests; a new connection where it closed one.
class LlrpTalk {
 public:
  explicit LlrpTalk(const Endpoint& at) : at_(at) {}
  void say(const Bytes& request) {
    if (!client_ || client_->is_over()) {
      client_.emplace(at_);
      decoder_.reset();
      (void)answer_to(0);
    }
    EXPECT_EQ(client_->say(request), request.size());
    const int type = robot::u16_from_be(request[0], request[1]) & 0x3FF;
    answered_ += answer_to(type == 72 ? 0 : type) ? 1 : 0;  // an acknowledged keepalive has no answer
  }
  [[nodiscard]] int answered() const { return answered_; }
  [[nodiscard]] int refused() const { return refused_; }

 private:
  /// Hears until something other than a report or an event came, half a second at most; without a request,
  /// until anything came.
  bool answer_to(int type) {
    for (int tries = 0; tries < 25; ++tries) {
      bool answered = false;
      for (const std::uint8_t byte : client_->hear(20)) {
        decoder_.room().front() = byte;
        decoder_.received(1);
      }
      while (const auto frame = decoder_.next()) {
        EXPECT_TRUE(*frame);
        const auto message = llrp::decode(**frame);
        EXPECT_TRUE(message);
        if (!message) {
          continue;
        }
        answered = answered || type == 0;
        std::visit(
            [&](const auto& answer) {
              if constexpr (requires { answer.status; }) {
                answered = true;
                refused_ += answer.status.ok() ? 0 : 1;
              }
            },
            *message);
      }
      if (answered) {
        return type != 0;
      }
    }
    return false;
  }

  Endpoint at_;
  std::optional<TcpClient> client_;
  llrp::FrameDecoder decoder_;
  int answered_{0};
  int refused_{0};
};

TEST_F(RecordedClients, SllurpTakesInventoryByTcpWithoutARefusal) {
  serve("hallway.yaml");
  const std::string devices = content_of(folder_ / "served/devices.yaml");
  const std::size_t at = devices.find("llrp: \"127.0.0.1:") + 17;
  const Endpoint endpoint{"127.0.0.1", static_cast<std::uint16_t>(std::atoi(devices.c_str() + at))};
  std::vector<fs::path> requests;
  for (const auto& entry : fs::directory_iterator{kVectors / "sllurp"}) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("inventory") && name.ends_with(".bin") && name.find("_c2r_") != std::string::npos) {
      requests.push_back(entry.path());
    }
  }
  std::ranges::sort(requests);
  LlrpTalk talk(endpoint);
  for (const fs::path& path : requests) {
    std::ifstream file{path, std::ios::binary};
    talk.say(Bytes(std::istreambuf_iterator<char>{file}, {}));
  }
  EXPECT_GE(talk.answered(), 25);
  EXPECT_EQ(talk.refused(), 0);
}

}  // namespace
}  // namespace sensotwin::twin
