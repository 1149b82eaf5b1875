// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <variant>

#include "twin/cli/commands.hpp"

/// Options that several commands share, spelt once.
namespace sensotwin::twin {

/// SCENE and --set. `choice` must outlive the parse.
void add_scene_and_changes(CLI::App& app, SceneChoice& choice);
/// SCENE, --seed and --set. `choice` must outlive the parse; so must what the other functions get.
void add_scene_options(CLI::App& app, SceneChoice& choice);
/// --out and --force.
void add_output_options(CLI::App& app, std::optional<std::filesystem::path>& out, bool& force,
                        const std::string& description);
/// --monitor [ADDR]. Empty: where there is room.
void add_monitor_option(CLI::App& app, std::optional<std::string>& monitor);
/// --seed N. \param store  called with each seed given
void add_seed_option(CLI::App& app, const std::function<void(std::uint64_t)>& store,
                     const std::string& description);

/// Check for an option's number: in [min, max]. CLI::Range lets "nan" through.
[[nodiscard]] CLI::Validator number_between(double min, double max);

/// "1..200", "7", "1..20,42": ascending, each once, at most 100 000; else what is wrong with the text.
[[nodiscard]] std::variant<std::vector<std::uint64_t>, std::string> seeds_from(const std::string& text);

/// Decimal or 0x... hexadecimal, 64 bits; nothing for other text (octal included: 010 is ten).
[[nodiscard]] std::optional<std::uint64_t> seed_from(const std::string& text);

}  // namespace sensotwin::twin
