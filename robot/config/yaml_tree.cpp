// SPDX-License-Identifier: MIT
#include "robot/config/yaml_tree.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <cctype>
#include <sstream>
#include <utility>

namespace sensotwin::robot {
namespace {

/// Builds the tree from yaml-cpp's events: they carry keys' places and keep duplicates, which its nodes do
/// not.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& source, std::vector<Problem>& problems)
      : source_(source), problems_(problems) {}

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    check_anchor(mark, anchor);
    add({YamlKind::kNothing, place(mark), "", false, {}, {}});
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, "an alias (*name)", "write the value out: a scene holds no references");
    add({YamlKind::kNothing, place(mark), "", false, {}, {}});
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_anchor(mark, anchor);
    const bool quoted = tag == "!";
    if (!quoted && !tag.empty() && tag != "?") {
      refuse(mark, fmt::format("the tag '{}'", tag), "write the value without a tag");
    }
    add({quoted ? YamlKind::kText : kind_of(value), place(mark), value, quoted, {}, {}});
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlKind::kList);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlKind::kSection);
  }
  void OnMapEnd() override { close(); }

  [[nodiscard]] YamlNode root() && { return std::move(root_); }

 private:
  struct Open {
    YamlNode node;
    bool has_key{false};
    std::string key;
    Place key_place;
  };

  [[nodiscard]] Place place(const YAML::Mark& mark) const {
    return {source_, mark.line + 1, mark.column + 1};
  }
  void refuse(const YAML::Mark& mark, const std::string& what, const std::string& hint) {
    problems_.push_back({place(mark), "", what + " is not supported", hint});
  }
  void check_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != YAML::NullAnchor) {
      refuse(mark, "an anchor (&name)", "write the value out: a scene holds no references");
    }
  }
  static YamlKind kind_of(const std::string& value) {
    if (value.empty() || value == "~" || value == "null") {
      return YamlKind::kNothing;
    }
    if (value == "true" || value == "false") {
      return YamlKind::kFlag;
    }
    return is_json_number(value) ? YamlKind::kNumber : YamlKind::kText;
  }
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlKind kind) {
    check_anchor(mark, anchor);
    if (!tag.empty() && tag != "?" && tag != "!") {
      refuse(mark, fmt::format("the tag '{}'", tag), "write the value without a tag");
    }
    stack_.push_back({{kind, place(mark), "", false, {}, {}}, false, "", {}});
  }
  void close() {
    YamlNode node = std::move(stack_.back().node);
    stack_.pop_back();
    add(std::move(node));
  }
  void add(YamlNode node) {
    if (stack_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = stack_.back();
    if (parent.node.kind == YamlKind::kList) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.has_key) {
      if (node.kind == YamlKind::kList || node.kind == YamlKind::kSection) {
        problems_.push_back({node.place, "", "a key is a list or a section", "a key is one word"});
      }
      if (node.text == "<<" && !node.quoted) {
        problems_.push_back({node.place, "", "a merge key (<<) is not supported",
                             "write the keys out: a scene holds no references"});
      }
      parent.has_key = true;
      parent.key = node.text;
      parent.key_place = node.place;
    } else {
      parent.has_key = false;
      if (node.kind == YamlKind::kNothing) {
        node.place = parent.key_place;  // yaml-cpp gives the place of whatever comes next
      }
      parent.node.entries.push_back({parent.key, parent.key_place, std::move(node)});
    }
  }

  std::string source_;
  std::vector<Problem>& problems_;
  std::vector<Open> stack_;
  YamlNode root_;
};

}  // namespace

const YamlEntry* YamlNode::find(const std::string& key) const {
  for (const YamlEntry& entry : entries) {
    if (entry.key == key) {
      return &entry;
    }
  }
  return nullptr;
}

std::string YamlNode::describe() const {
  constexpr std::size_t kShown = 40;
  std::string shown = text.size() > kShown ? text.substr(0, kShown) + "..." : text;
  switch (kind) {
    case YamlKind::kNothing:
      return "empty";
    case YamlKind::kText:
      return quoted ? fmt::format("the text \"{}\"", shown) : fmt::format("'{}'", shown);
    case YamlKind::kList:
      return "a list";
    case YamlKind::kSection:
      return "a section";
    default:
      return shown;
  }
}

YamlNode parse_yaml(const std::string& text, const std::string& source, std::vector<Problem>& problems) {
  std::istringstream stream(text);
  TreeBuilder builder(source, problems);
  try {
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) {
      return {};
    }
    YamlNode root = std::move(builder).root();
    TreeBuilder rest(source, problems);
    if (parser.HandleNextDocument(rest)) {
      const YamlNode second = std::move(rest).root();
      problems.push_back({second.place, "", "a second document", "one file holds one scene"});
    }
    return root;
  } catch (const YAML::Exception& error) {
    const bool tab = error.msg == "illegal map value" || error.msg.find("tab") != std::string::npos;
    problems.push_back({{source, error.mark.line + 1, error.mark.column + 1},
                        "",
                        "not YAML: " + error.msg,
                        tab ? "indent with spaces, not tabs, and put a space after each colon"
                            : "check indentation, brackets and quotes up to here"});
    return {};
  }
}

void set_place(YamlNode& node, const Place& place) {
  node.place = place;
  for (YamlNode& item : node.items) {
    set_place(item, place);
  }
  for (YamlEntry& entry : node.entries) {
    entry.key_place = place;
    set_place(entry.value, place);
  }
}

bool is_json_number(const std::string& text) {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t from = i;
    while (i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0) {
      ++i;
    }
    return i - from;
  };
  if (i < text.size() && text[i] == '-') {
    ++i;
  }
  const std::size_t whole_at = i;
  const std::size_t whole = digits();
  if (whole == 0 || (whole > 1 && text[whole_at] == '0')) {
    return false;
  }
  if (i < text.size() && text[i] == '.') {
    ++i;
    if (digits() == 0) {
      return false;
    }
  }
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) {
      ++i;
    }
    if (digits() == 0) {
      return false;
    }
  }
  return i == text.size();
}

}  // namespace sensotwin::robot
