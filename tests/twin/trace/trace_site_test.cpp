// SPDX-License-Identifier: MIT
#include "twin/trace/trace_site.hpp"

#include <gmock/gmock.h>

#include <string>

#include "trace_bench.hpp"

namespace sensotwin::twin {
namespace {

robot::HttpRequest request(std::string method, std::string path, std::string body = "") {
  robot::HttpRequest made{.method = std::move(method), .path = std::move(path), .body = std::move(body)};
  made.headers["Host"] = "127.0.0.1:8080";
  made.headers["Content-Length"] = std::to_string(made.body.size());
  return made;
}
/// As the page writes.
robot::HttpRequest written(std::string path, std::string body) {
  robot::HttpRequest made = request("POST", std::move(path), std::move(body));
  made.headers[std::string(robot::Site::kWriteHeader)] = "1";
  return made;
}

TEST(TraceSite, ServesThePageFromTheProgramItself) {
  TraceBench bench;
  const robot::Site site = trace_site(bench.session);
  const robot::HttpResponse page = site.answer(request("GET", "/"));
  EXPECT_EQ(page.status, 200);
  EXPECT_THAT(page.body, testing::HasSubstr("SensoTwin map tracer"));
  EXPECT_EQ(site.answer(request("GET", "/trace.js")).status, 200);
  EXPECT_EQ(site.answer(request("GET", "/trace.css")).status, 200);
}

TEST(TraceSite, WritesNothingForAPageOfAnotherSite) {
  TraceBench bench;
  const robot::Site site = trace_site(bench.session);
  const std::string body = TraceBench::to_save(small_document()).dump();
  EXPECT_EQ(site.answer(request("POST", "/api/save", body)).status, 403);
  robot::HttpRequest foreign = written("/api/save", body);
  foreign.headers["Host"] = "evil.example";
  EXPECT_EQ(site.answer(foreign).status, 403);
  EXPECT_TRUE(std::filesystem::is_empty(bench.folder.path()));
  EXPECT_EQ(site.answer(written("/api/save", body)).status, 200);
}

TEST(TraceSite, AnswersNothingWithoutTheTokenOnceItIsServedBeyondThisMachine) {
  TraceBench bench;
  robot::Site site = trace_site(bench.session);
  site.set_access({.loopback = false, .token = "0123456789abcdef0123456789abcdef"});
  EXPECT_GE(site.answer(request("GET", "/api/session")).status, 400);
  EXPECT_GE(site.answer(written("/api/check", "{}")).status, 400);
}

TEST(TraceSite, ReadsNoFileBesideItsOwn) {
  TraceBench bench;
  const robot::Site site = trace_site(bench.session);
  for (const char* path : {"/../trace.js", "/etc/passwd", "/api/plan/../../x", "/page.html", "/api"}) {
    EXPECT_EQ(site.answer(request("GET", path)).status, 404) << path;
  }
  robot::HttpRequest plan = request("GET", "/api/plan");
  plan.query["id"] = "../../etc/passwd";
  EXPECT_EQ(site.answer(plan).status, 404);
}

}  // namespace
}  // namespace sensotwin::twin
