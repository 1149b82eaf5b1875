// SPDX-License-Identifier: MIT
#include "twin/trace/trace_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <system_error>
#include <utility>

#include "robot/config/problem.hpp"
#include "robot/config/text_file.hpp"
#include "robot/output/exit_codes.hpp"
#include "robot/output/output_error.hpp"
#include "robot/output/output_file.hpp"
#include "twin/trace/plan_picture.hpp"
#include "twin/trace/trace_error.hpp"

namespace sensotwin::twin {
namespace {

constexpr std::size_t kNameMax = 100;
/// Chosen: what a plan may have (plan_picture.hpp) and what no text of ours reaches.
constexpr std::uintmax_t kFileMax = kPlanBytesMax;

/// Which kind a YAML file is, told by its keys at the start of a line; the readers judge it when it is
/// opened.
std::string kind_of_yaml(const std::filesystem::path& file) {
  std::error_code error;
  // Chosen: larger than any map of ours; a listing must not read megabytes.
  if (std::filesystem::file_size(file, error) > 1'000'000 || error) {
    return "";
  }
  std::string text;
  try {
    text = "\n" + robot::read_text_file(file, "YAML");
  } catch (const robot::LoadError&) {
    return "";
  }
  const auto has = [&](const char* key) { return text.find(std::string("\n") + key) != std::string::npos; };
  return has("places:") ? "hallways" : has("world:") ? "scene" : has("image:") ? "map" : "";
}

std::string kind_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const std::string extension = file.extension().string();
  if (name.ends_with(".trace.json")) {
    return "tracing";
  }
  if (extension == ".png" || extension == ".pgm") {
    return "picture";
  }
  return extension == ".yaml" || extension == ".yml" ? kind_of_yaml(file) : "";
}

}  // namespace

bool is_file_name(std::string_view name) {
  return !name.empty() && name.size() <= kNameMax && name.front() != '.' && name.front() != ' ' &&
         name.front() != '-' && name.back() != ' ' && std::all_of(name.begin(), name.end(), [](char c) {
           const auto byte = static_cast<unsigned char>(c);
           return byte >= 0x80 || std::isalnum(byte) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
         });
}

std::string stamp_of_content(std::string_view content) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : content) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return fmt::format("{:016x}", hash);
}

TraceFolder::TraceFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  if (folder_.empty()) {
    folder_ = ".";
  }
  std::filesystem::create_directories(folder_, error);
  if (!std::filesystem::is_directory(folder_)) {
    throw robot::OutputError(robot::ExitCode::kCannotCreate,
                             fmt::format("cannot create folder '{}'{}", folder_.string(),
                                         error ? ": " + error.message() : ": a file is in its place"));
  }
}

std::vector<TraceFile> TraceFolder::files() const {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator each(folder_, error), end; !error && each != end;
       each.increment(error)) {
    const std::string name = each->path().filename().string();
    if (is_file_name(name) && each->is_regular_file(error)) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  std::vector<TraceFile> found;
  for (const std::string& name : names) {
    const std::string kind = kind_of(folder_ / name);
    if (!kind.empty() && found.size() < kListedMax) {
      found.push_back({name, kind});
    }
  }
  return found;
}

std::filesystem::path TraceFolder::file(const std::string& name) const {
  if (!is_file_name(name)) {
    throw TraceError(TraceError::kBadRequest,
                     fmt::format("'{}' is not the name of a file in this folder", name));
  }
  std::filesystem::path path = folder_ / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw TraceError(TraceError::kNotFound, fmt::format("there is no file '{}' in this folder", name));
  }
  if (std::filesystem::canonical(path, error).parent_path() != std::filesystem::canonical(folder_, error)) {
    throw TraceError(TraceError::kBadRequest, fmt::format("'{}' leads out of this folder", name));
  }
  return path;
}

std::string TraceFolder::read(const std::string& name) const {
  const std::filesystem::path path = file(name);
  std::error_code error;
  if (std::filesystem::file_size(path, error) > kFileMax) {
    throw TraceError(TraceError::kTooLarge,
                     fmt::format("'{}' is larger than {} MB", name, kFileMax / 1'000'000));
  }
  return robot::read_text_file(path, "file");
}

std::optional<std::string> TraceFolder::stamp_of(const std::string& name) const {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(folder_ / name, error))) {
    return std::nullopt;
  }
  try {
    return stamp_of_content(read(name));
  } catch (const std::exception&) {
    return "unreadable";  // somebody else's, whatever it is
  }
}

std::vector<std::string> TraceFolder::conflicts(const FileContents& contents, const FileStamps& known) const {
  std::vector<std::string> names;
  for (const auto& [name, content] : contents) {
    const std::optional<std::string> there = stamp_of(name);
    const auto believed = known.find(name);
    const bool as_known = believed != known.end() && there == believed->second;
    if (there && !as_known && *there != stamp_of_content(content)) {
      names.push_back(name);
    }
  }
  return names;
}

FileStamps TraceFolder::write(const FileContents& contents) {
  FileStamps stamps;
  for (const auto& [name, content] : contents) {
    if (!is_file_name(name)) {
      throw TraceError(TraceError::kBadRequest,
                       fmt::format("'{}' is not the name of a file in this folder", name));
    }
  }
  for (const auto& [name, content] : contents) {
    try {
      robot::OutputFile out(folder_ / name);
      out.append(content);
      out.finish();
    } catch (const robot::OutputError& error) {
      throw TraceError(TraceError::kCannotWrite, error.what());
    }
    stamps[name] = stamp_of_content(content);
  }
  return stamps;
}

}  // namespace sensotwin::twin
