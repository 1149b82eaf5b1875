// SPDX-License-Identifier: MIT
#include "twin/trace/trace_site.hpp"

#include <string>
#include <utility>

namespace sensotwin::twin {
namespace {

robot::HttpHandler handler(TraceSession& session, const char* what, const char* parameter) {
  return [&session, what, parameter](const robot::HttpRequest& request) {
    TraceReply reply = session.answer(
        {what, std::string(*parameter != '\0' ? request.parameter(parameter) : ""), request.body});
    robot::HttpResponse response;
    response.status = reply.status;
    response.type = std::move(reply.type);
    response.body = std::move(reply.body);
    return response;
  };
}

}  // namespace

robot::Site trace_site(TraceSession& session) {
  robot::Site site(trace_files());
  site.on("GET", "/api/session", handler(session, "session", ""));
  site.on("GET", "/api/plan", handler(session, "plan", "id"));
  site.on("POST", "/api/upload", handler(session, "upload", "name"));
  for (const char* what : {"open", "check", "route", "scene", "save"}) {
    site.on("POST", std::string("/api/") + what, handler(session, what, ""));
  }
  return site;
}

}  // namespace sensotwin::twin
