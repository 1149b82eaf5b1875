// SPDX-License-Identifier: MIT
#include "robot/telemetry/web/site.hpp"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>
#include <string>

#include "robot/telemetry/web/access_token.hpp"

namespace sensotwin::robot {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::array<EmbeddedFile, 2> kFiles{{{"/", "text/html; charset=utf-8", "<!doctype html>"},
                                              {"/page.js", "text/javascript; charset=utf-8", "let a;"}}};

Site site_of(const SiteAccess& access = {}) {
  Site site(kFiles);
  site.on("GET", "/api/map", [](const HttpRequest&) { return HttpResponse{.body = "map"}; });
  site.on("PUT", "/api/map", [](const HttpRequest& request) { return HttpResponse{.body = request.body}; });
  site.on("GET", "/api/throws",
          [](const HttpRequest&) -> HttpResponse { throw std::runtime_error("/etc/secret"); });
  site.set_access(access);
  return site;
}

HttpRequest get(const std::string& path, const std::string& host = "localhost:8080") {
  return {.method = "GET", .path = path, .headers = {{"Host", host}}};
}

/// As the page itself writes.
HttpRequest put_map() {
  return {.method = "PUT",
          .path = "/api/map",
          .headers = {{"Host", "localhost:8080"},
                      {"Origin", "http://localhost:8080"},
                      {"Sec-Fetch-Site", "same-origin"},
                      {"Content-Length", "3"},
                      {"X-SensoTwin", "1"}},
          .body = "new"};
}

const SiteAccess kElsewhere{.loopback = false, .token = "0123456789abcdef", .cookie_name = "sensotwin_80"};

TEST(Site, GivesItsOwnFilesAndNothingBeside) {
  const Site site = site_of();
  EXPECT_EQ(site.answer(get("/")).body, "<!doctype html>");
  EXPECT_EQ(site.answer(get("/page.js")).type, "text/javascript; charset=utf-8");
  for (const char* path : {"/../etc/passwd", "/etc/passwd", "//", "/page.js/", "/page.js\0x", "/PAGE.JS",
                           "/.", "/..", "", "*", "/page.js/../page.js", "/..%2fpage.js", "\\page.js",
                           "file:///etc/passwd", "http://localhost/page.js"}) {
    EXPECT_EQ(site.answer(get(path)).status, std::string(path) == "/page.js" ? 200 : 404) << path;
  }
}

TEST(Site, IsNotReadByANameThatOnlyPointsToThisMachine) {
  const Site site = site_of();
  for (const char* host : {"localhost", "localhost:1", "127.0.0.1:8080", "127.0.0.2", "[::1]:8080"}) {
    EXPECT_EQ(site.answer(get("/", host)).status, 200) << host;
  }
  for (const char* host : {"evil.example", "evil.example:8080", "127.0.0.1.evil.example",
                           "localhost.evil.example", "192.168.1.7:8080", "[::2]:80", "[::1", "127.evil"}) {
    EXPECT_EQ(site.answer(get("/", host)).status, 403) << host;
  }
  EXPECT_EQ(site.answer(get("/", "")).status, 400);
}

TEST(Site, TakesAWriteFromItsOwnPage) {
  const HttpResponse response = site_of().answer(put_map());
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.body, "new");
}

TEST(Site, TakesNoWriteFromAnotherSite) {
  const Site site = site_of();
  HttpRequest foreign = put_map();
  foreign.headers["Origin"] = "http://evil.example";
  EXPECT_EQ(site.answer(foreign).status, 403);
  HttpRequest other_port = put_map();
  other_port.headers["Origin"] = "http://localhost:9";
  EXPECT_EQ(site.answer(other_port).status, 403);
  HttpRequest sandboxed = put_map();
  sandboxed.headers["Origin"] = "null";
  EXPECT_EQ(site.answer(sandboxed).status, 403);
  HttpRequest form = put_map();
  form.headers.erase("X-SensoTwin");
  EXPECT_EQ(site.answer(form).status, 403);
  HttpRequest fetched = put_map();
  fetched.headers.erase("Origin");
  fetched.headers["sec-fetch-site"] = "cross-site";
  EXPECT_EQ(site.answer(fetched).status, 403);
}

TEST(Site, ElsewhereThanOnLoopbackNothingIsAnsweredWithoutTheToken) {
  const Site site = site_of(kElsewhere);
  for (const char* path : {"/", "/page.js", "/api/map", "/nowhere"}) {
    EXPECT_EQ(site.answer(get(path, "192.168.1.7:80")).status, 401) << path;
  }
  HttpRequest wrong = get("/", "192.168.1.7:80");
  wrong.query["token"] = "0123456789abcdee";
  EXPECT_EQ(site.answer(wrong).status, 401);
  wrong.query["token"] = "";
  EXPECT_EQ(site.answer(wrong).status, 401);
  HttpRequest write = put_map();
  EXPECT_EQ(site.answer(write).status, 401);
}

TEST(Site, TheTokenMovesFromTheAddressIntoACookieThatScriptsCannotRead) {
  const Site site = site_of(kElsewhere);
  HttpRequest first = get("/", "192.168.1.7:80");
  first.query["token"] = kElsewhere.token;
  const HttpResponse moved = site.answer(first);
  EXPECT_EQ(moved.status, 303);
  EXPECT_EQ(moved.headers.at("Location"), "/");
  EXPECT_THAT(moved.headers.at("Set-Cookie"), HasSubstr("sensotwin_80=0123456789abcdef; "));
  EXPECT_THAT(moved.headers.at("Set-Cookie"), HasSubstr("HttpOnly"));
  HttpRequest then = get("/", "192.168.1.7:80");
  then.headers["Cookie"] = "a=b; sensotwin_80=0123456789abcdef; c=d";
  EXPECT_EQ(site.answer(then).status, 200);
  then.headers["Cookie"] = "xsensotwin_80=0123456789abcdef; sensotwin_8=0123456789abcdef";
  EXPECT_EQ(site.answer(then).status, 401);
}

TEST(Site, ProgramsBringTheTokenAsBearer) {
  HttpRequest request = get("/api/map", "192.168.1.7:80");
  request.headers["Authorization"] = "Bearer 0123456789abcdef";
  EXPECT_EQ(site_of(kElsewhere).answer(request).status, 200);
}

TEST(Site, TheTokenAloneDoesNotLetAnotherSiteWrite) {
  HttpRequest write = put_map();
  write.headers["Cookie"] = "sensotwin_80=0123456789abcdef";
  write.headers["Origin"] = "http://evil.example";
  EXPECT_EQ(site_of(kElsewhere).answer(write).status, 403);
}

TEST(Site, RefusesWhatMakesMuchWorkOfASmallRequest) {
  const Site site = site_of();
  HttpRequest ranges = get("/");
  ranges.headers["Range"] = "bytes=0-,0-,0-,0-";
  EXPECT_EQ(site.answer(ranges).status, 400);
  HttpRequest packed = put_map();
  packed.headers["Content-Encoding"] = "gzip";
  EXPECT_EQ(site.answer(packed).status, 400);
  HttpRequest chunked = put_map();
  chunked.headers["Transfer-Encoding"] = "chunked";
  EXPECT_EQ(site.answer(chunked).status, 411);
  HttpRequest form = put_map();
  form.headers["Content-Type"] = "multipart/form-data; boundary=x";
  EXPECT_EQ(site.answer(form).status, 415);
}

TEST(Site, SaysWhichMethodsItHasNot) {
  const Site site = site_of();
  HttpRequest request = get("/");
  request.method = "DELETE";
  EXPECT_EQ(site.answer(request).status, 405);
  HttpRequest write = put_map();
  write.path = "/page.js";
  EXPECT_EQ(site.answer(write).status, 405);
  write.path = "/nowhere";
  EXPECT_EQ(site.answer(write).status, 404);
}

TEST(Site, WhatAHandlerThrowsStaysInside) {
  const HttpResponse response = site_of().answer(get("/api/throws"));
  EXPECT_EQ(response.status, 500);
  EXPECT_THAT(response.body, Not(HasSubstr("secret")));
}

TEST(AccessToken, IsNewEachTimeAndLongEnoughNotToBeGuessed) {
  const std::string token = new_access_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, new_access_token());
}

TEST(AccessToken, EqualsItselfOnly) {
  EXPECT_TRUE(equal_in_constant_time("abc", "abc"));
  EXPECT_FALSE(equal_in_constant_time("abc", "abd"));
  EXPECT_FALSE(equal_in_constant_time("abc", "ab"));
}

}  // namespace
}  // namespace sensotwin::robot
