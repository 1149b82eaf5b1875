// SPDX-License-Identifier: MIT
#include "twin/scene/scene_schema.hpp"

#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "robot/config/number_text.hpp"
#include "twin/scene/fields.hpp"

namespace sensotwin::twin {
namespace {

using Json = nlohmann::ordered_json;

Json number_schema(const robot::Range& range) {
  Json schema{{"type", "number"}};
  if (range.min > std::numeric_limits<double>::lowest()) {
    schema[range.above_min ? "exclusiveMinimum" : "minimum"] = range.min;
  }
  if (range.max < std::numeric_limits<double>::max()) {
    schema["maximum"] = range.max;
  }
  return schema;
}

Json list_schema(Json items, robot::Count count) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", count.min}, {"maxItems", count.max}};
}

Json words_schema(std::span<const std::string_view> words) {
  return {{"enum", std::vector<std::string>(words.begin(), words.end())}};
}

class SchemaBuilder : public robot::FieldVisitor {
 public:
  SchemaBuilder() { open(); }
  [[nodiscard]] Json root() { return close(); }

  void number(const robot::Field& field, double& value, const robot::Range& range) override {
    put(field, number_schema(range), value);
  }
  void angle(const robot::Field& field, double& rad, const robot::Range& range_deg) override {
    put(field, number_schema(range_deg), robot::degrees_for(rad));
  }
  void integer(const robot::Field& field, std::int64_t& value, std::int64_t min, std::int64_t max) override {
    put(field, {{"type", "integer"}, {"minimum", min}, {"maximum", max}}, value);
  }
  void seed(const robot::Field& field, std::uint64_t& value) override {
    // As a double, 2^64: validators that hold whole numbers in 64 bits with a sign would read 2^64 - 1 as -1.
    put(field, {{"type", "integer"}, {"minimum", 0}, {"maximum", 0x1p64}}, value);
  }
  void flag(const robot::Field& field, bool& value) override { put(field, {{"type", "boolean"}}, value); }
  void text(const robot::Field& field, std::string&) override {
    put(field, {{"type", "string"}, {"minLength", 1}}, {});
  }
  void choice(const robot::Field& field, std::size_t& index,
              std::span<const std::string_view> words) override {
    put(field, words_schema(words), std::string(words[index]));
  }
  void point(const robot::Field& field, robot::Vec2& value, const robot::Range& range) override {
    put(field, list_schema(number_schema(range), {2, 2}), Json::array({value.x(), value.y()}));
  }
  void points(const robot::Field& field, std::vector<robot::Vec2>&, const robot::Range& range,
              robot::Count count) override {
    put(field, list_schema(list_schema(number_schema(range), {2, 2}), count), {});
  }
  void numbers(const robot::Field& field, std::vector<double>& value, const robot::Range& range,
               robot::Count count) override {
    put(field, list_schema(number_schema(range), count), value.empty() ? Json{} : Json(value));
  }
  void texts(const robot::Field& field, std::vector<std::string>&, robot::Count count) override {
    put(field, list_schema({{"type", "string"}, {"minLength", 1}}, count), {});
  }
  void hex(const robot::Field& field, std::span<std::uint8_t> value) override {
    const std::string digits = "^[0-9a-fA-F]{" + std::to_string(2 * value.size()) + "}$";
    put(field, {{"type", "string"}, {"pattern", digits}}, {});
  }
  void cells(const robot::Field& field, robot::Cells&) override {
    const Json whole{
        {"type", "integer"}, {"minimum", -robot::kFarthestTile}, {"maximum", robot::kFarthestTile}};
    put(field, list_schema(list_schema(whole, {2, 2}), {}), {});
  }
  void section(const robot::Field& field, const std::function<void()>& body) override {
    open();
    body();
    put(field, close(), {});
  }
  void section_or_word(const robot::Field& field, std::span<const std::string_view> words,
                       std::optional<std::size_t>, const std::function<void(std::size_t)>&,
                       const std::function<void()>& body) override {
    open();
    body();
    put(field, {{"oneOf", Json::array({words_schema(words), close()})}}, {});
  }
  void named(const robot::Field& field, std::size_t, const std::function<std::string(std::size_t)>&,
             const std::function<std::size_t(const std::string&)>& add,
             const std::function<void(std::size_t)>& body) override {
    open();
    body(add("any"));
    put(field,
        {{"type", "object"},
         {"patternProperties", {{robot::kNamePattern, close()}}},
         {"additionalProperties", false}},
        {});
  }
  void maybe(const robot::Field& field, bool, const std::function<void()>& set,
             const std::function<void()>& body) override {
    set();
    body();
    object()["properties"][std::string(field.key)].erase("default");
  }
  void list(const robot::Field& field, std::size_t, const std::function<void(std::size_t)>& resize,
            const std::function<void(std::size_t)>& body) override {
    resize(1);
    open();
    body(0);
    put(field, list_schema(close(), {}), {});
    resize(0);
  }
  void one_of(std::optional<std::size_t>, std::span<const Alternative> alternatives) override {
    std::vector<std::vector<std::string>> keys;
    for (const Alternative& alternative : alternatives) {
      const std::size_t before = object()["properties"].size();
      alternative.choose();
      alternative.body();
      keys.emplace_back();
      for (auto property = std::next(object()["properties"].begin(), static_cast<std::ptrdiff_t>(before));
           property != object()["properties"].end(); ++property) {
        keys.back().push_back(property.key());
      }
      object()["properties"][std::string(alternative.key)].erase("default");
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
      Json others = Json::array();
      for (std::size_t j = 0; j < keys.size(); ++j) {
        for (const std::string& key : j == i ? std::vector<std::string>{} : keys[j]) {
          others.push_back({{"required", Json::array({key})}});
        }
      }
      Json branch{{"required", Json::array({alternatives[i].key})}};
      if (!others.empty()) {
        branch["not"] = {{"anyOf", others}};
      }
      object()["oneOf"].push_back(branch);
    }
  }
  void some_of(std::initializer_list<std::string_view> keys) override {
    for (const std::string_view key : keys) {
      object()["anyOf"].push_back({{"required", Json::array({key})}});
    }
  }

 private:
  Json& object() { return objects_.back(); }
  void open() {
    objects_.push_back({{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}});
  }
  Json close() {
    Json done = std::move(objects_.back());
    objects_.pop_back();
    return done;
  }
  void put(const robot::Field& field, Json schema, const Json& value) {
    schema["description"] = field.help;
    if (field.required) {
      object()["required"].push_back(field.key);
    } else if (!value.is_null()) {
      schema["default"] = value;
    }
    object()["properties"][std::string(field.key)] = std::move(schema);
  }

  std::vector<Json> objects_;
};

}  // namespace

std::string scene_schema() {
  Scene defaults;
  defaults.mission.map.emplace();
  SchemaBuilder builder;
  visit_fields(builder, defaults);
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "SensoTwin scene"}};
  schema.update(builder.root());
  // Paths are made of all keys above, so the schema can only say what form they have.
  schema["properties"]["variants"] = {
      {"description", "changes by name, for --variant: paths as of --set, with the values to put there"},
      {"type", "object"},
      {"additionalProperties", {{"type", "object"}}}};
  return schema.dump(1) + "\n";
}

}  // namespace sensotwin::twin
