// SPDX-License-Identifier: MIT
#include "twin/cli/options.hpp"

#include <fmt/format.h>

#include <charconv>

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

void add_scene_options(CLI::App& app, SceneChoice& choice) {
  app.add_option("SCENE", choice.scene, "Scene file (YAML)")->required()->option_text(" ");
  add_seed_option(
      app, [&choice](std::uint64_t seed) { choice.seed = seed; }, "Seed instead of the scene's");
  app.add_option("--set", choice.set, "Change a value of the scene; may be repeated")
      ->option_text("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        const auto equals = text.find('=');
        return equals == std::string::npos || equals == 0 ? "'" + text + "' is not of the form key.path=value"
                                                          : std::string{};
      });
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
