// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace sensotwin::twin {

/// JSON Schema (draft 2020-12) of a scene file, for editors: completion, defaults, help. Made from the list
/// of fields that the reader reads; what the reader checks across fields (a start inside a wall) it does not
/// know. scenes/scene.schema.json is this text.
[[nodiscard]] std::string scene_schema();

}  // namespace sensotwin::twin
