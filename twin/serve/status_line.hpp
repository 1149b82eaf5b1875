// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "twin/serve/server.hpp"

namespace sensotwin::twin {

/// How it goes, in at most `columns` characters: the words at the end go first when there is no room.
[[nodiscard]] std::string status_line(const ServeStatus& status, int columns);

/// How it went: a line for the pace, a line for each wire.
[[nodiscard]] std::string table_of(const ServeStatus& status);

}  // namespace sensotwin::twin
