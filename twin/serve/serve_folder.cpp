// SPDX-License-Identifier: MIT
#include "twin/serve/serve_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "robot/output/output_error.hpp"

namespace sensotwin::twin {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw robot::OutputError(robot::ExitCode::kCannotCreate,
                           "cannot serve in '" + path.string() + "': " + reason);
}

}  // namespace

ServeFolder::ServeFolder(fs::path directory) : directory_(std::move(directory)) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) {
    refuse(directory_, error.message());
  }
  // The lock goes with the process, however it ends.
  const fs::path lock = directory_ / ".serve.lock";
  lock_ = Handle{::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)};
  if (!lock_) {
    refuse(directory_, std::system_category().message(errno));
  }
  if (::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    refuse(directory_, "another twin serve is at work here; give this one a folder of its own with --out");
  }
  fs::remove(directory_ / "devices.yaml", error);
}

ServeFolder::~ServeFolder() {
  std::error_code error;
  fs::remove(directory_ / "devices.yaml", error);
}

fs::path default_serve_folder(const fs::path& scene_file) {
  return fs::path{"runs"} / ("serve-" + scene_file.stem().string());
}

}  // namespace sensotwin::twin
