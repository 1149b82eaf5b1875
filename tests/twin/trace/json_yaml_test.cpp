// SPDX-License-Identifier: MIT
#include "twin/trace/json_yaml.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace sensotwin::twin {
namespace {

Json through_yaml(const Json& value) {
  std::vector<robot::Problem> problems;
  const robot::YamlNode node = robot::parse_yaml(yaml_of(value), "text", problems);
  EXPECT_TRUE(problems.empty()) << yaml_of(value);
  return json_of(node);
}

TEST(JsonYaml, ReadsBackToTheSame) {
  const Json value =
      Json::parse(R"({ "a": 1, "b": -0.5, "c": "12", "d": "?", "e": "a: b # c", "f": "\"q\" \\ \n\t",
      "g": [], "h": {}, "i": [[0, 1], [2, 3.25]], "j": [{ "k": "N", "l": [true, null] }, { "m": { "n": "é" } }],
      "true": false, "two words": "x", "1": "one", "deep": { "er": { "est": { "s": [1, 2] } } }, "null": "~" })");
  EXPECT_EQ(through_yaml(value), value) << yaml_of(value);
}

TEST(JsonYaml, BreaksLongListsIntoLines) {
  Json value = Json::object();
  for (int i = 0; i < 200; ++i) {
    value["points"].push_back({i, 1000 - i});
  }
  const std::string text = yaml_of(value);
  EXPECT_EQ(through_yaml(value), value);
  std::size_t longest = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    longest = std::max(longest, end - from);
    from = end + 1;
  }
  EXPECT_LE(longest, 120u) << text;
}

TEST(JsonYaml, LetsNoTextPassForSomethingElse) {
  for (const char* text : {"", "~", "null", "true", "yes", "0x10", "1e3", "- a", "{a: 1}", "&x", "*x", "!tag",
                           "a\u2028b", "#"}) {
    const Json value{{"key", text}, {text, "value"}};
    EXPECT_EQ(through_yaml(value), value) << yaml_of(value);
  }
}

}  // namespace
}  // namespace sensotwin::twin
