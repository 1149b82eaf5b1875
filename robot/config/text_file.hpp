// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace sensotwin::robot {

/// The whole of a file.
/// \param what  for messages: "scene", "robot file"
/// \throws LoadError  kExitMissing: it is not there or cannot be read; kExitInvalid: it is a folder or
/// larger than 1 GiB
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file, const std::string& what);

}  // namespace sensotwin::robot
