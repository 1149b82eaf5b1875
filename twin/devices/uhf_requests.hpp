// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "robot/wire/llrp/messages.hpp"
#include "twin/devices/uhf_settings.hpp"

namespace sensotwin::twin {

/// The response by which a request of that type is refused; nothing when it is no request that has one.
[[nodiscard]] std::optional<robot::llrp::Message> refusal_of(robot::llrp::MessageType request,
                                                             const robot::llrp::LlrpStatus& status);

/// Whether custom parameters may stand where they stand: Impinj's after its extensions are enabled, other
/// vendors' never.
[[nodiscard]] robot::llrp::LlrpStatus check_customs(const robot::llrp::RoSpec& spec, bool extended);
[[nodiscard]] robot::llrp::LlrpStatus check_customs(const robot::llrp::SetReaderConfig& request,
                                                    bool extended);
[[nodiscard]] robot::llrp::LlrpStatus check_customs(const robot::llrp::AccessSpec& spec, bool extended);

/// The part of the configuration that was asked for.
[[nodiscard]] robot::llrp::GetReaderConfigResponse part_of(const robot::llrp::GetReaderConfigResponse& all,
                                                           const robot::llrp::GetReaderConfig& request);

/// Obeys the request; nothing is changed when something of it is refused.
[[nodiscard]] robot::llrp::LlrpStatus apply(const robot::llrp::SetReaderConfig& request,
                                            const UhfReaderSettings& settings,
                                            robot::llrp::GetReaderConfigResponse& config);

}  // namespace sensotwin::twin
