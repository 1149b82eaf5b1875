// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace sensotwin::twin {

struct LibraryVersion {
  std::string name;
  std::string
      version;  ///< of the library that is loaded where it can tell, else of the package compiled against
};

/// Libraries behind this program, by name.
[[nodiscard]] std::vector<LibraryVersion> library_versions();

/// "twin 0.1.0" and a line feed.
[[nodiscard]] std::string version_text();
/// {"twin": "0.1.0", "libraries": {...}} and a line feed.
[[nodiscard]] std::string version_json();

}  // namespace sensotwin::twin
