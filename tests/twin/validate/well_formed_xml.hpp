// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace sensotwin::twin {

/// What is wrong with entities or angle brackets in a piece of text; empty when nothing.
inline std::string text_fault(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x20 && c != '\n' && c != '\t' && c != '\r') {
      return "control character";
    }
    if (c == '<') {
      return "bare <";
    }
    bool known = c != '&';
    for (const std::string_view entity : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      known = known || text.substr(i).starts_with(entity);
    }
    if (!known) {
      return "bare &";
    }
  }
  return "";
}

/// Splits `name a="b" c="d"`; \returns what is wrong with it.
inline std::string attributes_fault(std::string_view tag) {
  std::size_t at = tag.find(' ');
  while (at != std::string_view::npos && at < tag.size()) {
    const std::size_t open = tag.find("=\"", at);
    if (open == std::string_view::npos) {
      return tag.find_first_not_of(" ?", at) == std::string_view::npos ? "" : "attribute without value";
    }
    const std::size_t close = tag.find('"', open + 2);
    if (close == std::string_view::npos) {
      return "attribute without end";
    }
    if (const std::string fault = text_fault(tag.substr(open + 2, close - open - 2)); !fault.empty()) {
      return fault;
    }
    at = close + 1;
  }
  return "";
}

/// What keeps `xml` from being well-formed, of what we write: declaration, elements, attributes, text. Empty
/// when nothing. No comments, no CDATA.
inline std::string xml_fault(std::string_view xml) {
  std::vector<std::string> open;
  bool rooted = false;
  while (!xml.empty()) {
    const std::size_t begin = xml.find('<');
    if (const std::string fault = text_fault(xml.substr(0, begin)); !fault.empty()) {
      return fault;
    }
    if (begin == std::string_view::npos) {
      break;
    }
    const std::size_t end = xml.find('>', begin);
    if (end == std::string_view::npos) {
      return "tag without end";
    }
    std::string_view tag = xml.substr(begin + 1, end - begin - 1);
    xml.remove_prefix(end + 1);
    if (tag.starts_with('/')) {
      if (open.empty() || open.back() != tag.substr(1)) {
        return "unexpected </" + std::string(tag.substr(1)) + ">";
      }
      open.pop_back();
      continue;
    }
    const bool whole = tag.ends_with('/') || tag.starts_with('?');
    tag = tag.ends_with('/') ? tag.substr(0, tag.size() - 1) : tag;
    if (const std::string fault = attributes_fault(tag); !fault.empty()) {
      return fault;
    }
    if (open.empty() && !tag.starts_with('?')) {
      if (rooted) {
        return "two roots";
      }
      rooted = true;
    }
    if (!whole) {
      open.emplace_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty() && rooted ? "" : "not closed";
}

}  // namespace sensotwin::twin
