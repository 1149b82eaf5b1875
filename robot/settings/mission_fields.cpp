// SPDX-License-Identifier: MIT
#include "robot/settings/mission_fields.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace sensotwin::robot {
namespace {

constexpr std::array<std::string_view, 2> kPaceWords{"own", "paper"};
constexpr std::array<std::string_view, 2> kControllerWords{"fuzzy", "own"};
constexpr std::array<std::string_view, 2> kSetsWords{"reproduction", "tuned"};
constexpr std::array<std::string_view, 3> kPairingWords{"same_instant", "latest", "interpolated"};
constexpr std::array<std::string_view, 4> kPathWords{"polyline", "smooth", "circle", "circle_about"};
constexpr std::array<std::string_view, 2> kCornerWords{"constant", "slow"};
constexpr std::array<std::string_view, 3> kMissingWords{"search", "skip", "stop"};
constexpr std::array<std::string_view, 3> kOrderWords{"go_on", "exchange", "stop"};

/// As robot/mapping spells them, in the order of the enumeration. Made when first asked for, so that it is
/// there for whoever reads or writes a scene before main, in whatever order static objects are made.
std::span<const std::string_view> explorer_words() {
  static const auto words = [] {
    std::array<std::string_view, kExplorerKinds.size()> all;
    std::transform(kExplorerKinds.begin(), kExplorerKinds.end(), all.begin(),
                   [](ExplorerKind kind) { return name_of(kind); });
    return all;
  }();
  return words;
}

void trapezoid(FieldVisitor& v, const Field& field, Trapezoid& set) {
  std::vector<double> corners{set.left_foot, set.left_shoulder, set.right_shoulder, set.right_foot};
  v.numbers(field, corners, {-100.0, 100.0}, {4, 4});
  if (corners.size() == 4) {
    set = {corners[0], corners[1], corners[2], corners[3]};
  }
}

void sets_fields(FieldVisitor& v, FuzzySets& sets) {
  std::optional<double> zero_rad;
  std::optional<double> turn_radps;
  v.maybe({"z_rad", "zero is a triangle of this half width; the others end in it, rad"}, zero_rad,
          [&](double& value) {
            v.number({"z_rad", "half width of zero, rad"}, value, {0.001, 3.14});
          });
  v.maybe({"w_radps", "turn rate where the controller saturates, rad/s"}, turn_radps, [&](double& value) {
    v.number({"w_radps", "turn rate at saturation, rad/s"}, value, {0.001, 100.0});
  });
  if (zero_rad || turn_radps) {
    sets = fuzzy_sets(zero_rad.value_or(sets.zero_rad.right_foot),
                      turn_radps.value_or(sets.straight_radps.right_foot));
  }
  trapezoid(v, {"negative_rad", "feet and shoulders, rad"}, sets.negative_rad);
  trapezoid(v, {"zero_rad", "feet and shoulders, rad"}, sets.zero_rad);
  trapezoid(v, {"positive_rad", "feet and shoulders, rad"}, sets.positive_rad);
  trapezoid(v, {"clockwise_radps", "feet and shoulders, rad/s"}, sets.clockwise_radps);
  trapezoid(v, {"straight_radps", "feet and shoulders, rad/s"}, sets.straight_radps);
  trapezoid(v, {"counter_clockwise_radps", "feet and shoulders, rad/s"}, sets.counter_clockwise_radps);
}

void phase_mission_fields(FieldVisitor& v, PhaseMission& mission) {
  v.choice({"controller", "the paper's fuzzy one, or our own estimator"}, mission.controller,
           kControllerWords);
  v.texts({"destinations", "names of tags in order, each as often as wanted; empty: all as listed"},
          mission.destinations, {0, 1000});
  v.texts({"exchanged", "names of two tags whose codes the robot was told the wrong way round"},
          mission.exchanged, {0, 2});
  v.number({"speed_mps", "driving, m/s"}, mission.speed_mps, {0.01, 0.45});
  v.section_or_word(
      {"sets", "fuzzy: reproduction (the paper's figures), tuned, or figures"}, kSetsWords,
      mission.sets == kReproductionSets ? std::optional<std::size_t>{0}
      : mission.sets == kTunedSets      ? std::optional<std::size_t>{1}
                                        : std::nullopt,
      [&](std::size_t word) { mission.sets = word == 0 ? kReproductionSets : kTunedSets; },
      [&] { sets_fields(v, mission.sets); });
  v.choice({"pairing", "fuzzy: how readings of two antennas become one difference"}, mission.pairing,
           kPairingWords);
  v.choice({"path", "own: how it runs through the tags' projections"}, mission.path, kPathWords);
  std::size_t corners = mission.slow_corners ? 1 : 0;
  v.choice({"corners", "own: at constant speed, or braking and turning on the spot"}, corners, kCornerWords);
  mission.slow_corners = corners == 1;
  v.number({"circle_radius_m", "own, circle_about the first tag: its radius, m"}, mission.circle_radius_m,
           {0.2, 100.0});
  v.number({"circle_laps", "own, circle_about: how often round"}, mission.circle_laps, {0.1, 1000.0});
  v.choice({"on_missing", "own: what to do about a tag that is not heard"}, mission.on_missing,
           kMissingWords);
  v.number({"order_factor", "own: doubts the list where the next tag but one is so much nearer; 0: never"},
           mission.order_factor, {0.0, 100.0});
  v.choice({"on_order", "own: what to do then"}, mission.on_order, kOrderWords);
  v.maybe({"corridor_half_width_m", "own: stops rather than be further from its path, m"},
          mission.corridor_half_width_m, [&](double& value) {
            v.number({"corridor_half_width_m", "m"}, value, {0.01, 100.0});
          });
}

void pace_fields(FieldVisitor& v, PaceSection& pace) {
  v.number({"tile_s", "least time from tile to tile, s; 0: as fast as it goes"}, pace.tile_s, {0.0, 3600.0});
  v.number({"tag_s", "time that a new tag costs, s; 0: as fast as the reader goes"}, pace.tag_s,
           {0.0, 3600.0});
  v.number({"speed_mps", "driving, m/s"}, pace.speed_mps, {0.01, 0.5});
  v.angle({"turn_degps", "turning on the spot, degrees/s"}, pace.turn_radps, {1.0, 240.0});
}

void place_name(FieldVisitor& v, const Field& field, std::string& name) {
  v.maybe(
      field, !name.empty(), [] {}, [&] { v.text(field, name); });
}

void hallway_fields(FieldVisitor& v, HallwaySection& mission) {
  place_name(v, {"from", "place where it stands; left out: the first tag tells"}, mission.from);
  place_name(v, {"to", "place to go to"}, mission.to);
  v.flag({"survey", "draws the hallway map instead of using one"}, mission.survey);
  v.number({"speed_mps", "driving, m/s"}, mission.speed_mps, {0.05, 0.45});
  static constexpr std::array<std::string_view, 3> kLines{"middle", "left", "right"};
  v.choice({"follow", "the middle of each hallway, or one of its walls"}, mission.follow, kLines);
  v.number({"wall_m", "from the wall that is followed, m; at most half the hallway's width"}, mission.wall_m,
           {0.25, 3.0});
}

}  // namespace

void mission_fields(FieldVisitor& v, Mission& mission) {
  const std::array<FieldVisitor::Alternative, 3> missions{{
      {"map", [&] { mission.map.emplace(); },
       [&] {
         v.section({"map", "SensoBot: map the carpet"}, [&] {
           v.choice({"explorer", "order in which tiles are visited"}, mission.map->explorer,
                    explorer_words());
           v.section_or_word(
               {"pace", "how fast it works: own, paper (3.4 s a tile, 4.4 s a new tag), or figures"},
               kPaceWords, std::nullopt,
               [&](std::size_t word) { mission.map->pace = word == 1 ? kPaperPace : PaceSection{}; },
               [&] { pace_fields(v, mission.map->pace); });
         });
       }},
      {"phase", [&] { mission.phase.emplace(); },
       [&] {
         v.section({"phase", "Gueaieb & Miah: along ceiling tags by phase difference"},
                   [&] { phase_mission_fields(v, *mission.phase); });
       }},
      {"hallway", [&] { mission.hallway.emplace(); },
       [&] {
         v.section({"hallway", "Tsukiyama: through hallways by places and tags"},
                   [&] { hallway_fields(v, *mission.hallway); });
       }},
  }};
  v.one_of(mission.map       ? std::optional<std::size_t>{0}
           : mission.phase   ? std::optional<std::size_t>{1}
           : mission.hallway ? std::optional<std::size_t>{2}
                             : std::nullopt,
           missions);
}

}  // namespace sensotwin::robot
