// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "robot/config/nearest_name.hpp"
#include "twin/cli/options.hpp"
#include "twin/output/summary.hpp"

namespace sensotwin::twin {
namespace {

void print(const std::vector<ListEntry>& entries, Context& context) {
  if (context.json) {
    auto json = nlohmann::ordered_json::array();
    for (const auto& [name, summary] : entries) {
      json.push_back({{"name", name}, {"summary", summary}});
    }
    context.out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    return;
  }
  std::size_t width = 0;
  for (const ListEntry& entry : entries) {
    width = std::max(width, entry.name.size());
  }
  for (const auto& [name, summary] : entries) {
    context.out << (summary.empty() ? name : fmt::format("{:<{}}  {}", name, width, summary)) << '\n';
  }
}

robot::ExitCode list(const std::vector<ListTopic>& topics, const std::string& wanted, Context& context) {
  std::vector<ListEntry> names;
  for (const ListTopic& topic : topics) {
    if (topic.name == wanted) {
      print(topic.entries(), context);
      return robot::ExitCode::kDone;
    }
    names.push_back({topic.name, topic.summary});
  }
  if (wanted.empty()) {
    print(names, context);
    return robot::ExitCode::kDone;
  }
  std::vector<std::string> known;
  known.reserve(names.size());
  for (const ListEntry& name : names) {
    known.push_back(name.name);
  }
  throw CommandError(robot::ExitCode::kWrongCommandLine,
                     fmt::format("there is no list of '{}'{}; there are {}", wanted,
                                 robot::did_you_mean(wanted, known), fmt::join(known, ", ")));
}

/// The lesson that a scene opens with.
std::string first_comment(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    const auto text = line.find_first_not_of("# \t");
    if (!line.starts_with("#")) {
      break;
    }
    const bool directive = line.starts_with("# yaml-language-server") || line.starts_with("# SPDX");
    if (text != std::string::npos && !directive) {
      return line.substr(text);
    }
  }
  return "";
}

}  // namespace

std::vector<std::filesystem::path> scene_files(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  const auto folder = std::find_if(folders.begin(), folders.end(), [&](const std::filesystem::path& each) {
    return std::filesystem::is_directory(each, error);
  });
  if (folder == folders.end()) {
    return files;
  }
  for (const auto& entry : std::filesystem::directory_iterator(*folder, error)) {
    if (entry.path().extension() == ".yaml") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Command make_list_command(std::vector<ListTopic> topics) {
  const auto wanted = std::make_shared<std::string>();
  return {
      .name = "list",
      .summary = "say what there is",
      .examples = "twin list\ntwin list scenes\ntwin list figures --json",
      .set_up =
          [wanted](CLI::App& app) {
            app.add_option("TOPIC", *wanted, "What to list (default: the topics)")->option_text(" ");
          },
      .run = [wanted,
              topics = std::move(topics)](Context& context) { return list(topics, *wanted, context); },
  };
}

ListTopic scenes_topic(std::vector<std::filesystem::path> folders) {
  return {"scenes", "scene files and what they teach", [folders = std::move(folders)] {
            std::vector<ListEntry> entries;
            for (const auto& file : scene_files(folders)) {
              entries.push_back({file.string(), first_comment(file)});
            }
            return entries;
          }};
}

ListTopic figures_topic() {
  return {"figures", "figures of summary.json that expect: may ask for", [] {
            std::vector<ListEntry> entries;
            for (const std::string& name : figure_names()) {
              entries.push_back({name, ""});
            }
            return entries;
          }};
}

ListTopic exit_codes_topic() {
  return {"exit-codes", "what the process says when it ends", [] {
            std::vector<ListEntry> entries;
            entries.reserve(robot::kExitCodeMeanings.size());
            for (const auto& [code, meaning] : robot::kExitCodeMeanings) {
              entries.push_back({std::to_string(robot::as_int(code)), std::string{meaning}});
            }
            return entries;
          }};
}

}  // namespace sensotwin::twin
