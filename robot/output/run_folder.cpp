// SPDX-License-Identifier: MIT
#include "robot/output/run_folder.hpp"

#include <cassert>
#include <system_error>
#include <utility>
#include <vector>

#include "robot/output/output_error.hpp"

namespace sensotwin::robot {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw OutputError(ExitCode::kCannotCreate, "cannot create '" + path.string() + "': " + reason);
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    refuse(folder, error.message());
  }
  if (!fs::is_directory(folder, error)) {
    refuse(folder, "it exists and is not a folder");
  }
}

/// An earlier run's verdict, and what a killed run left under temporary names.
void remove_leftovers(const fs::path& folder) {
  std::vector<fs::path> leftovers{folder / "summary.json", folder / "timing.json"};
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path name = entry.path().filename();
    // ".trace.csv.part", or ".plan.part.png" where another library wrote.
    if (name.string().starts_with(".") &&
        (name.extension() == ".part" || name.stem().extension() == ".part")) {
      leftovers.push_back(entry.path());
    }
  }
  for (const fs::path& file : leftovers) {
    fs::remove(file, error);
    if (error) {
      refuse(file, error.message());
    }
  }
}

}  // namespace

RunFolder::RunFolder(fs::path directory, Existing existing) : directory_(std::move(directory)) {
  create_folder(directory_);
  std::error_code error;
  const bool empty = fs::is_empty(directory_, error);
  if (error) {
    refuse(directory_, error.message());
  }
  if (empty) {
    return;
  }
  if (existing == Existing::kRefuse) {
    refuse(directory_, "the folder is not empty (--force replaces the files of a run in it)");
  }
  remove_leftovers(directory_);
}

fs::path RunFolder::prepare(std::string_view name) {
  const fs::path relative{name};
  assert(!relative.empty() && relative.is_relative());
  if (relative.has_parent_path()) {
    create_folder(directory_ / relative.parent_path());
  }
  return directory_ / relative;
}

void RunFolder::write(std::string_view name, std::string_view content) {
  OutputFile file = stream(name);
  file.append(content);
  file.finish();
}

OutputFile RunFolder::stream(std::string_view name) {
  return OutputFile{prepare(name)};
}

void RunFolder::write_by(std::string_view name, const std::function<void(const fs::path&)>& writer) {
  const fs::path final_path = prepare(name);
  // Libraries choose a format by the extension, so here it stays last.
  const fs::path part_path = final_path.parent_path() /
                             ("." + final_path.stem().string() + ".part" + final_path.extension().string());
  std::error_code error;
  try {
    writer(part_path);
  } catch (...) {
    fs::remove(part_path, error);
    throw;
  }
  fs::rename(part_path, final_path, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(part_path, error);
    throw OutputError(ExitCode::kIoError, "cannot write '" + final_path.string() + "': " + reason);
  }
}

fs::path default_run_folder(std::string_view scene, std::uint64_t seed, std::string_view utc) {
  std::string name{scene};
  name.append("-").append(std::to_string(seed)).append("-").append(utc);
  return fs::path{"runs"} / name;
}

fs::path default_validation_folder(std::string_view scene, std::string_view utc) {
  std::string name = "validate-";
  name.append(scene).append("-").append(utc);
  return fs::path{"runs"} / name;
}

}  // namespace sensotwin::robot
