// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "robot/telemetry/web/http.hpp"
#include "robot/telemetry/web/site.hpp"
#include "twin/trace/plan_picture.hpp"
#include "twin/trace/trace_session.hpp"

namespace sensotwin::twin {

/// The page, made from page/bundle.
[[nodiscard]] std::span<const robot::EmbeddedFile> trace_files();

/// The page and what it asks: "/api/" and the word of TraceSession. \param session  outlives the site
[[nodiscard]] robot::Site trace_site(TraceSession& session);

/// What the server must let through: a picture.
inline constexpr std::size_t kTraceBodyMax = kPlanBytesMax;

}  // namespace sensotwin::twin
