// SPDX-License-Identifier: MIT
#include "twin/scene/scene_schema.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"
#include "scene_texts.hpp"

namespace sensotwin::twin {
namespace {

using nlohmann::json;

json json_of(const robot::YamlNode& node) {
  switch (node.kind) {
    case robot::YamlKind::kNothing:
      return nullptr;
    case robot::YamlKind::kFlag:
      return node.text == "true";
    case robot::YamlKind::kNumber:
      return json::parse(node.text, nullptr, false);
    case robot::YamlKind::kText:
      return node.text;
    case robot::YamlKind::kList: {
      json list = json::array();
      for (const robot::YamlNode& item : node.items) {
        list.push_back(json_of(item));
      }
      return list;
    }
    case robot::YamlKind::kSection:
      break;
  }
  json object = json::object();
  for (const robot::YamlEntry& entry : node.entries) {
    object[entry.key] = json_of(entry.value);
  }
  return object;
}

class Schema {
 public:
  Schema() {
    const json document = json::parse(scene_schema());
    const valijson::adapters::NlohmannJsonAdapter adapter(document);
    valijson::SchemaParser parser;
    parser.populateSchema(adapter, schema_);
  }
  /// \returns what the schema has against the scene; empty when nothing
  std::string against(const std::string& yaml) {
    std::vector<robot::Problem> problems;
    const json scene = json_of(robot::parse_yaml(yaml, "s.yaml", problems));
    const valijson::adapters::NlohmannJsonAdapter adapter(scene);
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(schema_, adapter, &results)) {
      return "";
    }
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
      for (const std::string& step : error.context) {
        text += step;
      }
      text += ": " + error.description + "\n";
    }
    return text;
  }

 private:
  valijson::Schema schema_;
};

TEST(SceneSchema, IsTheOneThatIsPublished) {
  const std::filesystem::path published =
      std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes/scene.schema.json";
  const std::filesystem::path fresh = "scene.schema.json";
  const bool same =
      std::filesystem::exists(published) && robot::read_text_file(published, "schema") == scene_schema();
  if (!same) {
    std::ofstream(fresh) << scene_schema();
  }
  EXPECT_TRUE(same) << "copy " << std::filesystem::absolute(fresh) << " over " << published;
}

TEST(SceneSchema, AcceptsThePublishedScenes) {
  Schema schema;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(SENSOTWIN_SOURCE_DIR) / "scenes")) {
    if (entry.path().extension() == ".yaml") {
      EXPECT_EQ(schema.against(robot::read_text_file(entry.path(), "scene")), "") << entry.path();
    }
  }
}

/// Changes that a schema can judge; the last word of each pair says whether it is sound.
struct Edit {
  const char* find;
  const char* replace;
  bool sound;
};

const std::vector<Edit> kEdits{
    {"seed: 7", "seed: 8", true},
    {"seed: 7", "seed: -1", false},
    {"seed: 7", "seed: 7.5", false},
    {"seed: 7", "seed: \"7\"", false},
    {"seed: 7", "seed: 010", false},
    {"seed: 7\n", "", false},
    {"version: 1", "version: 2", false},
    {"seed: 7", "seed: 7\ntitle: Words", true},
    {"seed: 7", "seed: 7\ntitle: 12", false},
    {"seed: 7", "seed: 7\nsede: 7", false},
    {"tile_m: 0.5", "tile_m: 5.1", false},
    {"tile_m: 0.5", "tile_m: .nan", false},
    {"tile_m: 0.5", "tile_m: [0.5]", false},
    {"tile_m: 0.5", "tile_m:", false},
    {"carpet: { tile_m: 0.5 }", "carpet: {}", true},
    {"carpet: { tile_m: 0.5 }", "carpet: some", false},
    {"tile_m: 0.5", "tile_m: 0.5, without: [[0, 0]]", true},
    {"tile_m: 0.5", "tile_m: 0.5, without: [[0, 0.5]]", false},
    {"tile_m: 0.5", "tile_m: 0.5, without: [[0]]", false},
    {"tile_m: 0.5", "tile_m: 0.5, region_m: [[0, 0], [2, 2]]", true},
    {"tile_m: 0.5", "tile_m: 0.5, region_m: [[0, 0]]", false},
    {"size_m: [1, 0.5]", "radius_m: 0.3", true},
    {"size_m: [1, 0.5]", "radius_m: 0", false},
    {"size_m: [1, 0.5]", "legs_m: [[0, 0]], leg_radius_m: 0.02", true},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], leg_radius_m: 0.02", false},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], radius_m: 0.3", false},
    {", size_m: [1, 0.5]", "", false},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5, 2]", false},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], pushable: true", true},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], pushable: on", false},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], tag: { category: 1, length: 2, width: 3, color: 4 }", true},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], tag: { category: 1, length: 2, width: 3 }", false},
    {"size_m: [1, 0.5]", "size_m: [1, 0.5], tag: { category: 256, length: 2, width: 3, color: 4 }", false},
    {"  room:", "  map: { file: m.yaml }\n  room:", false},
    {"room: { walls_m: [[0, 0], [4, 0], [4, 3], [0, 3]] }", "room: {}", false},
    {"{ min: 1 }", "{ min: 1, rate: { min: 0.95 }, median: { max: 3 } }", true},
    {"{ min: 1 }", "{ min: 1, rate: { min: 95 } }", false},
    {"{ min: 1 }", "{ min: 1, rate: 0.95 }", false},
    {"{ min: 1 }", "{ quantile_97_5: { min: 2 } }", true},
    {"{ min: 1 }", "{ quantile_97_5: {} }", false},
    {"{ min: 1 }", "{ quantile_96: { min: 2 } }", false},
    {"robot:", "robot:\n  base: { firmware: wifi }", true},
    {"robot:", "robot:\n  base: { firmware: new }", false},
    {"{ at_m: [1, 1], heading_deg: 0 }", "auto", true},
    {"{ at_m: [1, 1], heading_deg: 0 }", "anywhere", false},
    {"at_m: [1, 1], heading", "heading", false},
    {"{ explorer: idfm }", "{ explorer: idfm, pace: own }", true},
    {"{ explorer: idfm }", "{ explorer: idfm, pace: { tile_s: 2 } }", true},
    {"{ explorer: idfm }", "{ explorer: idfm, pace: { tile_s: -2 } }", false},
    {"{ explorer: idfm }", "{ explorer: random }", false},
    {"map: { explorer: idfm }", "fly: { explorer: idfm }", false},
    {"{ min: 1 }", "{ max: 3 }", true},
    {"{ min: 1 }", "{}", false},
    {"{ min: 1 }", "{ min: 1, mean: 2 }", false},
    {"tiles_mapped", "Tiles", false},
    {"expect:", "time_limit_s: 0\nexpect:", false},
};

TEST(SceneSchema, AgreesWithTheReaderOnSoundAndBrokenScenes) {
  Schema schema;
  ASSERT_EQ(schema.against(kSoundScene), "");
  for (const Edit& edit : kEdits) {
    const std::string text = edited(kSoundScene, edit.find, edit.replace);
    EXPECT_EQ(schema.against(text).empty(), edit.sound) << edit.replace << "\n" << schema.against(text);
    EXPECT_EQ(messages(text) == "no error", edit.sound) << edit.replace << "\n" << messages(text);
  }
}

}  // namespace
}  // namespace sensotwin::twin
