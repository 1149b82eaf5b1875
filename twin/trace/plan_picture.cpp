// SPDX-License-Identifier: MIT
#include "twin/trace/plan_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "render/image.hpp"
#include "render/png_writer.hpp"
#include "robot/config/problem.hpp"
#include "robot/config/text_file.hpp"
#include "robot/config/yaml_tree.hpp"
#include "twin/scene/map_import.hpp"
#include "twin/trace/json_yaml.hpp"

namespace sensotwin::twin {
namespace {

constexpr const char* kExpected = "expected a floor plan: a PNG or PGM picture, or the YAML of a map";
/// Finest cell of an exported map. Chosen: twice the finest that read_map() takes; 2 cm show every wall.
constexpr double kFinestCell_m = 0.02;

[[noreturn]] void refuse(const std::string& name, std::string what) {
  throw robot::LoadError({{{name, 0, 0}, "", std::move(what), kExpected}}, robot::kExitInvalid);
}

bool is_png(const std::string& bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

/// Width times height as a PNG's first chunk says it (ISO/IEC 15948, 11.2.2): looked at before anything is
/// unpacked, since a picture of a few kilobytes may unpack to gigabytes.
std::optional<std::uint64_t> announced_pixels(const std::string& png) {
  constexpr std::size_t kWidthAt = 16;
  if (png.size() < kWidthAt + 8) {
    return std::nullopt;
  }
  const auto word = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(png[at + i]);
    }
    return value;
  };
  return word(kWidthAt) * word(kWidthAt + 4);
}

GreyPicture decoded(const std::string& bytes, const std::string& name) {
  auto picture = decode_picture(bytes);
  if (!picture) {
    refuse(name, picture.error());
  }
  return std::move(*picture);
}

/// The mean of red, green and blue as one level. \param clear  level of what is transparent
std::uint8_t level_of(std::uint16_t grey, std::uint8_t clear) {
  return grey == GreyPicture::kClear ? clear : static_cast<std::uint8_t>((grey + 1) / 3);
}

std::string encoded(const GreyPicture& grey) {
  render::Image image(grey.columns, grey.rows);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.columns; ++x) {
      const std::uint8_t level =
          level_of(grey.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(grey.columns) +
                               static_cast<std::size_t>(x)],
                   255);
      image.at(x, y) = {level, level, level, 255};
    }
  }
  const auto png = render::encode_png(image, {});
  return png ? std::string(png->begin(), png->end()) : std::string{};
}

/// The darkest of each square of `factor` pixels.
GreyPicture merged(const GreyPicture& fine, int factor) {
  GreyPicture coarse{(fine.columns + factor - 1) / factor, (fine.rows + factor - 1) / factor, {}};
  coarse.pixels.assign(static_cast<std::size_t>(coarse.columns) * static_cast<std::size_t>(coarse.rows),
                       GreyPicture::kClear);
  for (int y = 0; y < fine.rows; ++y) {
    for (int x = 0; x < fine.columns; ++x) {
      const std::uint16_t grey =
          fine.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.columns) +
                      static_cast<std::size_t>(x)];
      std::uint16_t& cell =
          coarse.pixels[static_cast<std::size_t>(y / factor) * static_cast<std::size_t>(coarse.columns) +
                        static_cast<std::size_t>(x / factor)];
      cell = std::min(cell, grey);  // clear is the largest
    }
  }
  return coarse;
}

}  // namespace

PlanPicture plan_from_bytes(const std::string& bytes, const std::string& name) {
  if (bytes.empty()) {
    refuse(name, "is empty");
  }
  if (bytes.size() > kPlanBytesMax) {
    refuse(name, fmt::format("is larger than {} MB", kPlanBytesMax / 1'000'000));
  }
  const bool png = is_png(bytes);
  if (png && announced_pixels(bytes).value_or(0) > kPlanPixelsMax) {
    refuse(name, fmt::format("has more than {} million pixels", kPlanPixelsMax / 1'000'000));
  }
  const GreyPicture picture = decoded(bytes, name);
  if (picture.pixels.size() > kPlanPixelsMax) {
    refuse(name, fmt::format("has more than {} million pixels", kPlanPixelsMax / 1'000'000));
  }
  PlanPicture plan;
  plan.name = name;
  plan.columns = picture.columns;
  plan.rows = picture.rows;
  plan.png = png ? bytes : encoded(picture);
  return plan;
}

PlanPicture read_plan(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".yaml" && extension != ".yml") {
    PlanPicture plan = plan_from_bytes(robot::read_text_file(file, "floor plan"), file.string());
    plan.name = file.filename().string();
    return plan;
  }
  // Checks every key, and that the picture is whole.
  const OccupancyMap map = read_map(file);
  std::vector<robot::Problem> problems;
  const Json keys = json_of(robot::parse_yaml(robot::read_text_file(file, "map"), file.string(), problems));
  const std::filesystem::path picture = file.parent_path() / keys.value("image", std::string{});
  PlanPicture plan = plan_from_bytes(robot::read_text_file(picture, "picture"), picture.string());
  plan.name = file.filename().string();
  plan.resolution_m = map.resolution_m;
  plan.X_WO = map.X_WO;
  plan.scaled = true;
  const auto number = [&](const char* key, double otherwise) {
    const auto found = keys.find(key);
    return found != keys.end() && found->is_number() ? found->get<double>() : otherwise;
  };
  plan.occupied_thresh = number("occupied_thresh", plan.occupied_thresh);
  plan.free_thresh = number("free_thresh", plan.free_thresh);
  const auto negate = keys.find("negate");
  plan.negate = negate != keys.end() && (*negate == 1 || *negate == true);
  return plan;
}

MapFiles map_files(const PlanPicture& plan, const std::string& pgm_name) {
  GreyPicture picture = decoded(plan.png, plan.name);
  const int rows = picture.rows;
  int factor = 1;
  if (plan.resolution_m < kFinestCell_m) {
    factor = static_cast<int>(std::ceil(kFinestCell_m / plan.resolution_m));
    picture = merged(picture, factor);
  }
  std::string pgm = fmt::format("P5\n{} {}\n255\n", picture.columns, picture.rows);
  pgm.reserve(pgm.size() + picture.pixels.size());
  // Nothing was drawn there: between free and occupied, so unknown.
  const double unknown = (plan.free_thresh + plan.occupied_thresh) / 2.0;
  const auto clear = static_cast<std::uint8_t>(std::lround(255.0 * (plan.negate ? unknown : 1.0 - unknown)));
  for (const std::uint16_t grey : picture.pixels) {
    pgm += static_cast<char>(level_of(grey, clear));
  }
  // Merging may add a part of a row below the picture's own lower edge.
  const double below_m = (picture.rows * factor - rows) * plan.resolution_m;
  const robot::Vec2 corner_m = plan.X_WO * robot::Vec2{0.0, -below_m};
  const Json keys{{"image", pgm_name},
                  {"resolution", plan.resolution_m * factor},
                  {"origin", {corner_m.x(), corner_m.y(), plan.X_WO.yaw_rad}},
                  {"negate", plan.negate ? 1 : 0},
                  {"occupied_thresh", plan.occupied_thresh},
                  {"free_thresh", plan.free_thresh}};
  return {std::move(pgm), yaml_of(keys)};
}

}  // namespace sensotwin::twin
