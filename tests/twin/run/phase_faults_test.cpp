// SPDX-License-Identifier: MIT
// What goes wrong between tags, reader and robot, end to end in the hallway: our own controller notices, says
// so, and stays inside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "phase_case.hpp"
#include "twin/run/ideal_path.hpp"
#include "twin/run/phase_twin.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::size_t kHeaderBytes = 10;       // LLRP 1.0.1, section 16.1
constexpr std::uint16_t kRoAccessReport = 61;  // same, section 16.1.1

/// An LLRP connection that may be pulled out, and may lose whole reports.
class FaultyReaderLink final : public robot::ByteLink {
 public:
  FaultyReaderLink(robot::ByteLink& inner, double lose, robot::RandomStream random)
      : inner_(inner), lose_(lose), random_(random) {}

  bool cut{false};
  int lost{0};

 private:
  bool do_write(robot::ByteView bytes) override { return !cut && inner_.write(bytes); }
  std::size_t do_read(std::span<std::uint8_t> into) override {
    std::array<std::uint8_t, 4096> piece{};
    while (const std::size_t count = inner_.read(piece)) {
      held_.insert(held_.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
    }
    if (cut) {
      held_.clear();
      passed_.clear();
      return 0;
    }
    pass_whole_messages();
    const std::size_t count = std::min(into.size(), passed_.size());
    std::copy_n(passed_.begin(), count, into.begin());
    passed_.erase(passed_.begin(), passed_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  [[nodiscard]] bool do_is_up() const override { return !cut && inner_.is_up(); }

  void pass_whole_messages() {
    while (held_.size() >= kHeaderBytes) {
      const auto type = static_cast<std::uint16_t>((held_[0] & 3u) << 8 | held_[1]);
      const std::size_t length = static_cast<std::size_t>(held_[2]) << 24 |
                                 static_cast<std::size_t>(held_[3]) << 16 |
                                 static_cast<std::size_t>(held_[4]) << 8 | held_[5];
      if (held_.size() < length) {
        return;
      }
      const auto end = held_.begin() + static_cast<std::ptrdiff_t>(length);
      if (type == kRoAccessReport && random_.chance(lose_)) {
        ++lost;
      } else {
        passed_.insert(passed_.end(), held_.begin(), end);
      }
      held_.erase(held_.begin(), end);
    }
  }

  robot::ByteLink& inner_;
  double lose_;
  robot::RandomStream random_;
  std::vector<std::uint8_t> held_;
  std::vector<std::uint8_t> passed_;
};

/// A run with a faulty reader link, and what came of it.
class FaultyRun {
 public:
  explicit FaultyRun(const Scene& scene, double lose = 0.0, const PhaseTwin::Retelling& retell = {})
      : scene_(scene), path_(scene_) {
    twin_.emplace(
        scene_,
        [&](const robot::PhaseLinks& links) -> robot::PhaseLinks {
          link_.emplace(links.uhf_reader, lose, robot::RandomStream(99));
          return {links.base, *link_, links.floor_reader, links.sensors};
        },
        retell);
  }

  void run_until(double until_s) {
    while (!twin_->done() && robot::to_s(twin_->now()) < until_s) {
      twin_->tick();
      for (const robot::PhaseEvent& event : twin_->program().take_events()) {
        said_.emplace_back(event.name);
      }
      off_path_m_ = std::max(off_path_m_, path_.distance_m(twin_->world().X_WR().p_m));
    }
  }
  [[nodiscard]] bool said(const std::string& name) const {
    return std::find(said_.begin(), said_.end(), name) != said_.end();
  }
  [[nodiscard]] bool arrived() const { return twin_->program().arrived(); }
  [[nodiscard]] double off_path_m() const { return off_path_m_; }
  [[nodiscard]] std::uint64_t wall_contacts() const { return twin_->world().contacts().wall; }
  [[nodiscard]] double end_error_m() const { return (twin_->world().X_WR().p_m - path_.end_m()).norm(); }
  FaultyReaderLink& link() { return *link_; }

 private:
  Scene scene_;
  IdealPath path_;
  std::optional<FaultyReaderLink> link_;
  std::optional<PhaseTwin> twin_;
  std::vector<std::string> said_;
  double off_path_m_{0.0};
};

const std::vector<std::string> kOwn{"mission.phase.controller=own", "mission.phase.corners=slow"};

Scene own_hallway(std::vector<std::string> more = {}) {
  more.insert(more.begin(), kOwn.begin(), kOwn.end());
  return published("hallway", more);
}

TEST(FaultyRadio, WithoutFaultsArrivesWithinCentimetres) {
  FaultyRun run(own_hallway());
  run.run_until(600.0);
  EXPECT_TRUE(run.arrived());
  EXPECT_LT(run.end_error_m(), 0.1);
  EXPECT_EQ(run.wall_contacts(), 0u);
}

TEST(FaultyRadio, SilentForTwoSecondsIsSaidAndTheRobotArrives) {
  FaultyRun run(own_hallway());
  run.run_until(30.0);
  run.link().cut = true;
  run.run_until(32.0);
  run.link().cut = false;
  run.run_until(600.0);
  EXPECT_TRUE(run.said("reader_silent"));
  EXPECT_TRUE(run.said("reader_back"));
  EXPECT_TRUE(run.arrived());
  EXPECT_EQ(run.wall_contacts(), 0u);
}

TEST(FaultyRadio, ThatLosesHalfTheReadsCostsNoTag) {
  FaultyRun run(own_hallway(), 0.5);
  run.run_until(600.0);
  EXPECT_GT(run.link().lost, 1000);
  EXPECT_TRUE(run.arrived());
  EXPECT_EQ(run.wall_contacts(), 0u);
}

TEST(FaultyRadio, WithOneTagMissingSkipsItWithAWord) {
  FaultyRun run(own_hallway({"world.ceiling_tags[6].present=false"}));
  run.run_until(900.0);
  EXPECT_TRUE(run.said("tag_missing"));
  EXPECT_TRUE(run.said("tag_skipped"));
  EXPECT_EQ(run.wall_contacts(), 0u);
}

TEST(FaultyRadio, WithExchangedCablesIsFoundOutAndArrives) {
  FaultyRun run(own_hallway(), 0.0, [](robot::PhaseProgramConfig& config) {
    auto& antennas = std::get<robot::CeilingMissionConfig>(config.mission).estimator.reader.antennas;
    std::swap(antennas[0], antennas[1]);
  });
  run.run_until(900.0);
  EXPECT_TRUE(run.said("cables_swapped"));
  EXPECT_TRUE(run.arrived());
  EXPECT_EQ(run.wall_contacts(), 0u);
}

TEST(FaultyRadio, WithThreeTimesTheNoiseArrives) {
  FaultyRun run(own_hallway({"world.radio.noise_scale=3"}));
  run.run_until(900.0);
  EXPECT_TRUE(run.arrived());
  EXPECT_EQ(run.wall_contacts(), 0u);
}

/// What is said in one run of a variant of the hallway, whose expectations of each run it must keep.
std::vector<std::string> said_in(const std::string& variant, std::uint64_t seed,
                                 const std::string& name = "hallway") {
  const Scene scene = read_scene(kSource / "scenes" / (name + ".yaml"), {.seed = seed, .variant = variant});
  const TemporaryFolder folder;
  const Summary summary = phase_run(folder / "run", scene);
  EXPECT_EQ(summary.path->wall_contacts, 0) << variant;
  for (const auto& judged : summary.expect) {
    EXPECT_TRUE(judged.ok) << variant << ": " << judged.asked.name;
  }
  std::vector<std::string> said;
  const std::string events = content_of(folder / "run/events.jsonl");
  const std::string key = "\"event\":\"";
  for (std::size_t at = events.find(key); at != std::string::npos; at = events.find(key, at + 1)) {
    const std::size_t begin = at + key.size();
    said.push_back(events.substr(begin, events.find('"', begin) - begin));
  }
  return said;
}

// The same over 200 seeds: tests/twin/run/phase_long_test.cpp and docs/phase.md.
TEST(FaultyHallway, WithARealReaderThatFallsSilentIsSaidAndDoesNoHarm) {
  EXPECT_THAT(said_in("fault_silent", 1), testing::IsSupersetOf({"reader_silent", "reader_back", "arrived"}));
}

TEST(FaultyHallway, WithARealReaderWhoseCablesAreSwappedIsFoundOut) {
  EXPECT_THAT(said_in("fault_cables", 1), testing::IsSupersetOf({"cables_swapped", "arrived"}));
}

// Echoes of these two rooms fit exchanged cables for a while; every tag is then dropped again and again.
TEST(RealReader, WhoseCablesAreTakenForSwappedByMistakeIsDoubtedAndBothTagsAreReached) {
  for (const std::uint64_t seed : {20u, 62u}) {
    EXPECT_THAT(said_in("r420", seed, "line_at_90"),
                testing::IsSupersetOf({"cables_swapped", "cables_doubted", "arrived"}));
  }
}

TEST(FaultyHallway, WithATagThatFellOffEndsAtTheOneBeforeIt) {
  EXPECT_THAT(said_in("fault_missing", 1), testing::IsSupersetOf({"tag_missing", "stopped"}));
}

TEST(FaultyHallway, WithTwoCodesExchangedIsDoubtedAndPutRight) {
  EXPECT_THAT(said_in("fault_exchanged", 1),
              testing::IsSupersetOf({"order_doubtful", "order_exchanged", "arrived"}));
}

}  // namespace
}  // namespace sensotwin::twin
