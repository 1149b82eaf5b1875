// SPDX-License-Identifier: MIT
#include "robot/config/field_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "robot/config/nearest_name.hpp"

namespace sensotwin::robot {

FieldReader::FieldReader(const YamlNode& root, std::vector<Problem>& problems) : problems_(problems) {
  places_[""] = {root.place.source, std::max(root.place.line, 1), std::max(root.place.column, 1)};
  frames_.push_back({&root, "", places_[""], {}});
}

void FieldReader::finish() {
  leave();
}

Place FieldReader::place(std::string path) const {
  while (true) {
    const auto found = places_.find(path);
    if (found != places_.end()) {
      return found->second;
    }
    const std::size_t cut = path.find_last_of(".[");
    path = cut == std::string::npos ? "" : path.substr(0, cut);
  }
}

std::string FieldReader::path_of(std::string_view key) const {
  const std::string& path = frames_.back().path;
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

void FieldReader::add(const Place& place, const std::string& path, std::string what, std::string hint) {
  problems_.push_back({place, path, std::move(what), std::move(hint)});
}

void FieldReader::wrong(const YamlNode& node, const std::string& path, const std::string& expected) {
  add(node.place, path, "is " + node.describe(), "expected " + expected);
}

void FieldReader::know(std::string_view key) {
  std::vector<std::string>& known = frames_.back().known;
  if (std::find(known.begin(), known.end(), key) == known.end()) {
    known.emplace_back(key);
  }
}

const YamlNode* FieldReader::take(const Field& field) {
  know(field.key);
  const Frame& frame = frames_.back();
  const YamlEntry* entry = frame.node->find(std::string(field.key));
  const std::string path = path_of(field.key);
  if (!instead_of_.empty()) {
    if (entry != nullptr) {
      add(entry->key_place, path, fmt::format("does not go with '{}'", instead_of_), "leave one of them out");
    }
    return nullptr;
  }
  if (entry == nullptr) {
    if (field.required) {
      add(frame.place, path, "is missing", fmt::format("expected a value ({})", field.help));
    }
    return nullptr;
  }
  places_[path] = entry->value.place;
  return &entry->value;
}

void FieldReader::enter(const YamlNode& node, const std::string& path, const Place& place,
                        const std::function<void()>& body) {
  if (node.kind != YamlKind::kSection) {
    wrong(node, path, "a section (key: value)");
    return;
  }
  frames_.push_back({&node, path, place, {}});
  body();
  leave();
}

void FieldReader::leave() {
  const Frame frame = std::move(frames_.back());
  frames_.pop_back();
  std::vector<std::string> seen;
  for (const YamlEntry& entry : frame.node->entries) {
    const std::string path = frame.path.empty() ? entry.key : frame.path + "." + entry.key;
    if (std::find(seen.begin(), seen.end(), entry.key) != seen.end()) {
      add(entry.key_place, path, "is given twice",
          fmt::format("it stands in {} too", frame.node->find(entry.key)->key_place.text()));
      continue;
    }
    seen.push_back(entry.key);
    if (std::find(frame.known.begin(), frame.known.end(), entry.key) == frame.known.end()) {
      add(entry.key_place, path, "unknown key",
          fmt::format("expected one of: {}{}", fmt::join(frame.known, ", "),
                      did_you_mean(entry.key, frame.known)));
    }
  }
}

void FieldReader::section(const Field& field, const std::function<void()>& body) {
  if (const YamlNode* node = take(field)) {
    const Place key_place = frames_.back().node->find(std::string(field.key))->key_place;
    enter(*node, path_of(field.key), key_place, body);
  }
}

void FieldReader::section_or_word(const Field& field, std::span<const std::string_view> words,
                                  std::optional<std::size_t>,
                                  const std::function<void(std::size_t)>& take_word,
                                  const std::function<void()>& body) {
  const YamlNode* node = take(field);
  if (node == nullptr) {
    return;
  }
  if (node->kind == YamlKind::kSection) {
    enter(*node, path_of(field.key), frames_.back().node->find(std::string(field.key))->key_place, body);
    return;
  }
  const auto found = std::find(words.begin(), words.end(), node->text);
  if (node->kind != YamlKind::kText || found == words.end()) {
    wrong(*node, path_of(field.key),
          "a section, or the word " + fmt::format("{}", fmt::join(words, " or ")) +
              did_you_mean(node->text, {words.begin(), words.end()}));
    return;
  }
  take_word(static_cast<std::size_t>(found - words.begin()));
}

void FieldReader::named(const Field& field, std::size_t, const std::function<std::string(std::size_t)>&,
                        const std::function<std::size_t(const std::string&)>& add_named,
                        const std::function<void(std::size_t)>& body) {
  section(field, [&] {
    const Frame& frame = frames_.back();
    const YamlNode& node = *frame.node;
    const std::string path = frame.path;
    for (const YamlEntry& entry : node.entries) {
      const bool word =
          !entry.key.empty() &&
          entry.key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") == std::string::npos;
      const std::string entry_path = path + "." + entry.key;
      know(entry.key);
      places_[entry_path] = entry.key_place;
      if (!word) {
        add(entry.key_place, entry_path, "is no name", "expected small letters, digits, _ and .");
        continue;
      }
      if (node.find(entry.key) == &entry) {
        enter(entry.value, entry_path, entry.key_place, [&] { body(add_named(entry.key)); });
      }
    }
  });
}

void FieldReader::maybe(const Field& field, bool, const std::function<void()>& set,
                        const std::function<void()>& body) {
  know(field.key);
  if (frames_.back().node->find(std::string(field.key)) == nullptr) {
    return;
  }
  if (instead_of_.empty()) {
    set();
  }
  body();
}

void FieldReader::list(const Field& field, std::size_t, const std::function<void(std::size_t)>& resize,
                       const std::function<void(std::size_t)>& body) {
  const YamlNode* node = take(field);
  const std::string path = path_of(field.key);
  if (node == nullptr || !list_in(*node, path, {}, "sections")) {
    return;
  }
  resize(0);
  resize(node->items.size());
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const YamlNode& item = node->items[i];
    const std::string item_path = fmt::format("{}[{}]", path, i);
    places_[item_path] = item.place;
    enter(item, item_path, item.place, [&] { body(i); });
  }
}

void FieldReader::one_of(std::optional<std::size_t>, std::span<const Alternative> alternatives) {
  if (!instead_of_.empty()) {
    return;
  }
  const Alternative* chosen = nullptr;
  std::vector<std::string_view> keys;
  for (const Alternative& alternative : alternatives) {
    keys.push_back(alternative.key);
    if (chosen == nullptr && frames_.back().node->find(std::string(alternative.key)) != nullptr) {
      chosen = &alternative;
    }
  }
  if (chosen == nullptr) {
    for (const std::string_view key : keys) {
      know(key);
    }
    const std::string what =
        fmt::format("needs {}{}", keys.size() > 1 ? "one of: " : "", fmt::join(keys, ", "));
    add(frames_.back().place, frames_.back().path, what, "none is given");
    return;
  }
  chosen->choose();
  chosen->body();
  for (const Alternative& alternative : alternatives) {
    if (&alternative != chosen) {
      instead_of_ = chosen->key;
      alternative.body();
      instead_of_.clear();
    }
  }
}

void FieldReader::some_of(std::initializer_list<std::string_view> keys) {
  const Frame& frame = frames_.back();
  for (const std::string_view key : keys) {
    if (frame.node->find(std::string(key)) != nullptr) {
      return;
    }
  }
  add(frame.place, frame.path, fmt::format("needs {}", fmt::join(keys, " or ")), "none is given");
}

}  // namespace sensotwin::robot
