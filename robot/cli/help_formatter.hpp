// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sensotwin::robot {

/// Help that opens with examples: what it does, examples, usage, operands, options, exit codes (of `twin`
/// alone). An App's footer holds its examples.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();
  // NOLINTNEXTLINE(readability-identifier-naming): CLI11's names
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace sensotwin::robot
