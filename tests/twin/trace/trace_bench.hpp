// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/robot/output/temporary_folder.hpp"
#include "twin/trace/json_yaml.hpp"
#include "twin/trace/trace_session.hpp"

namespace sensotwin::twin {

/// Three places as the page sends them: c with tags to the north and east, d north of it, f east of it, and a
/// hallway out of d that nobody has followed.
inline Json small_document() {
  return Json::parse(R"({
    "tracing": 1, "plan": null,
    "hallways": { "version": 1, "width_m": 2, "places": [
      { "name": "c", "at_m": [0, 0], "N": { "to": "d", "length_m": 6, "tags": ["6"] },
                                     "E": { "to": "f", "length_m": 8, "tags": ["9"] } },
      { "name": "d", "at_m": [0, 6], "S": { "to": "c", "length_m": 6, "tags": ["11"] },
                                     "E": { "to": "?", "tags": ["12"] } },
      { "name": "f", "at_m": [8, 0], "W": { "to": "c", "length_m": 8, "tags": ["17"] } } ] },
    "scene": { "kind": "hallway", "walls": "hallways", "title": "Three places", "seed": 7,
               "from": "c", "to": "f" } })");
}

/// A session over two folders of its own, and what it says.
class TraceBench {
 public:
  TraceBench() : session(folder.path(), scratch.path()) {}

  TraceReply raw(const std::string& what, const std::string& body, const std::string& argument = "") {
    return session.answer({what, argument, body});
  }
  Json ask(const std::string& what, const Json& body, int status = 200) {
    const TraceReply reply = raw(what, body.dump());
    EXPECT_EQ(reply.status, status) << reply.body;
    return Json::parse(reply.body);
  }
  static Json to_save(const Json& document) {
    return {{"document", document}, {"name", "three"}, {"hallways_file", "three.hallways.yaml"}};
  }
  void put(const std::string& name, const std::string& content) {
    std::ofstream(folder / name, std::ios::binary) << content;
  }
  [[nodiscard]] std::string content(const std::string& name) const { return content_of(folder / name); }

  TemporaryFolder folder;
  TemporaryFolder scratch;
  TraceSession session;
};

}  // namespace sensotwin::twin
