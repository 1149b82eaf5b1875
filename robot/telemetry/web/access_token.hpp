// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace sensotwin::robot {

/// 128 bits from the operating system, as 32 hexadecimal digits: what only the person who started the server,
/// and whoever was given the address, can know. \throws WebError
[[nodiscard]] std::string new_access_token();

/// Takes as long whichever character differs, so that a token cannot be guessed one by one.
[[nodiscard]] bool equal_in_constant_time(std::string_view a, std::string_view b);

}  // namespace sensotwin::robot
