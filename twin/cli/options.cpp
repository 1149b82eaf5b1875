// SPDX-License-Identifier: MIT
#include "twin/cli/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "robot/telemetry/web/web_address.hpp"

namespace sensotwin::twin {

std::optional<std::uint64_t> seed_from(const std::string& text) {
  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  const char* const begin = text.data() + (hexadecimal ? 2 : 0);
  const char* const end = text.data() + text.size();
  std::uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(begin, end, seed, hexadecimal ? 16 : 10);
  if (error != std::errc{} || stop != end || begin == end) {
    return std::nullopt;
  }
  return seed;
}

CLI::Validator number_between(double min, double max) {
  return CLI::Validator{
      [min, max](const std::string& text) {
        double value = 0.0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool good = error == std::errc{} && stop == end && value >= min && value <= max;
        return good ? std::string{} : fmt::format("'{}' is no number from {} to {}", text, min, max);
      },
      ""};
}

void add_monitor_option(CLI::App& app, std::optional<std::string>& monitor) {
  app.add_option_function<std::vector<std::string>>(
         "--monitor",
         [&monitor](const std::vector<std::string>& given) { monitor = given.empty() ? "" : given.front(); },
         "Serve a page that draws what happens (127.0.0.1:8420, else any free port); a token is asked for "
         "when it is reached from other machines")
      ->option_text("[HOST:PORT]")
      ->expected(0, 1)
      ->check([](const std::string& given) { return robot::complaint_about_web_address(given); });
}

void add_seed_option(CLI::App& app, const std::function<void(std::uint64_t)>& store,
                     const std::string& description) {
  app.add_option_function<std::string>(
         "--seed",
         [store](const std::string& text) {
           const auto seed = seed_from(text);
           if (!seed) {
             throw CLI::ValidationError("--seed",
                                        "'" + text + "' is no number from 0 to 2^64-1 (decimal or 0x...)");
           }
           store(*seed);
         },
         description)
      ->option_text("N");
}

std::variant<std::vector<std::uint64_t>, std::string> seeds_from(const std::string& text) {
  // Chosen: at some 5 kB of figures a seed, half a gigabyte.
  constexpr std::size_t kSeedsMax = 100'000;
  std::vector<std::uint64_t> seeds;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const std::size_t dots = part.find("..");
    const auto first = seed_from(part.substr(0, dots));
    const auto last = dots == std::string::npos ? first : seed_from(part.substr(dots + 2));
    if (!first || !last) {
      return fmt::format("'{}' is no seed and no range of seeds such as 1..200", part);
    }
    if (*last < *first) {
      return fmt::format("'{}' runs backwards", part);
    }
    if (*last - *first >= kSeedsMax - seeds.size()) {
      return fmt::format("'{}' makes more than {} seeds", text, kSeedsMax);
    }
    for (std::uint64_t seed = *first;; ++seed) {
      seeds.push_back(seed);
      if (seed == *last) {
        break;
      }
    }
    begin = end + 1;
  }
  std::sort(seeds.begin(), seeds.end());
  const auto twice = std::adjacent_find(seeds.begin(), seeds.end());
  if (twice != seeds.end()) {
    return fmt::format("seed {} is there twice", *twice);
  }
  return seeds;
}

namespace {

void add_scene_operand(CLI::App& app, SceneChoice& choice) {
  app.add_option("SCENE", choice.scene, "Scene file (YAML)")->required()->option_text(" ");
}

void add_changes(CLI::App& app, SceneChoice& choice) {
  app.add_option("--variant", choice.variant, "One of the scene's variants")->option_text("NAME");
  app.add_option("--set", choice.set, "Change a value of the scene; may be repeated")
      ->option_text("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        const auto equals = text.find('=');
        return equals == std::string::npos || equals == 0 ? "'" + text + "' is not of the form key.path=value"
                                                          : std::string{};
      });
}

}  // namespace

void add_scene_options(CLI::App& app, SceneChoice& choice) {
  add_scene_operand(app, choice);
  add_seed_option(
      app, [&choice](std::uint64_t seed) { choice.seed = seed; }, "Seed instead of the scene's");
  add_changes(app, choice);
}

void add_scene_and_changes(CLI::App& app, SceneChoice& choice) {
  add_scene_operand(app, choice);
  add_changes(app, choice);
}

void add_output_options(CLI::App& app, std::optional<std::filesystem::path>& out, bool& force,
                        const std::string& description) {
  app.add_option_function<std::string>(
         "--out", [&out](const std::string& path) { out = path; }, description)
      ->option_text("PATH")
      ->check([](const std::string& text) {
        return text.empty() ? std::string{"the path is empty"} : std::string{};
      });
  app.add_flag("--force", force, "Replace what is there");
}

}  // namespace sensotwin::twin
