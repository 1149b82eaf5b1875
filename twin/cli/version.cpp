// SPDX-License-Identifier: MIT
#include "twin/cli/version.hpp"

#include <cairo.h>
#include <fmt/format.h>
#include <png.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace sensotwin::twin {

std::vector<LibraryVersion> library_versions() {
  return {
      {"Box2D", SENSOTWIN_BOX2D_VERSION},  // 2.4.1 calls itself 2.4.0 in b2_version
      {"cairo", cairo_version_string()},
      {"CLI11", CLI11_VERSION},
      {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"libpng", png_get_libpng_ver(nullptr)},
      {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                    NLOHMANN_JSON_VERSION_PATCH)},
      {"yaml-cpp", SENSOTWIN_YAML_CPP_VERSION},
  };
}

std::string version_text() {
  return fmt::format("twin {}\n", SENSOTWIN_VERSION);
}

std::string version_json() {
  nlohmann::ordered_json json{{"twin", SENSOTWIN_VERSION}};
  for (const auto& [name, version] : library_versions()) {
    json["libraries"][name] = version;
  }
  return json.dump(2) + "\n";
}

}  // namespace sensotwin::twin
