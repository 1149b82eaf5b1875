// SPDX-License-Identifier: MIT
#include "robot/output/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "robot/output/output_error.hpp"

namespace sensotwin::robot {
namespace {

// Chosen: large enough that system calls vanish beside formatting, small enough to stay in the L2 cache.
constexpr std::size_t kBufferSize = 65536;
static_assert(kBufferSize >= OutputFile::kRoomMax);

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

}  // namespace

std::filesystem::path part_path_of(const std::filesystem::path& final_path) {
  return final_path.parent_path() / ("." + final_path.filename().string() + ".part");
}

OutputFile::OutputFile(std::filesystem::path final_path)
    : final_path_(std::move(final_path)),
      part_path_(part_path_of(final_path_)),
      buffer_(new char[kBufferSize]) {
  do {
    descriptor_ = ::open(part_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EINTR);
  if (descriptor_ < 0) {
    throw OutputError(ExitCode::kCannotCreate,
                      "cannot create '" + final_path_.string() + "': " + reason(errno));
  }
}

OutputFile::~OutputFile() {
  discard();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : final_path_(std::move(other.final_path_)),
      part_path_(std::move(other.part_path_)),
      buffer_(std::move(other.buffer_)),
      fill_(std::exchange(other.fill_, 0)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this != &other) {
    discard();
    final_path_ = std::move(other.final_path_);
    part_path_ = std::move(other.part_path_);
    buffer_ = std::move(other.buffer_);
    fill_ = std::exchange(other.fill_, 0);
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

void OutputFile::append(std::string_view text) {
  while (!text.empty()) {
    if (fill_ == kBufferSize) {
      flush();
    }
    const std::size_t part = std::min(text.size(), kBufferSize - fill_);
    std::memcpy(buffer_.get() + fill_, text.data(), part);
    fill_ += part;
    text.remove_prefix(part);
  }
}

char* OutputFile::room(std::size_t size) {
  assert(size <= kRoomMax);
  if (kBufferSize - fill_ < size) {
    flush();
  }
  return buffer_.get() + fill_;
}

void OutputFile::flush() {
  assert(descriptor_ >= 0);
  std::size_t done = 0;
  while (done < fill_) {
    const ssize_t written = ::write(descriptor_, buffer_.get() + done, fill_ - done);
    if (written < 0) {
      if (errno != EINTR) {
        fail(errno);
      }
    } else {
      done += static_cast<std::size_t>(written);
    }
  }
  fill_ = 0;
}

void OutputFile::finish() {
  flush();
  // close() is where a network file system confesses that the disk was full.
  if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
    fail(errno);
  }
  if (::rename(part_path_.c_str(), final_path_.c_str()) != 0) {
    fail(errno);
  }
  part_path_.clear();
}

void OutputFile::fail(int error_number) {
  discard();
  throw OutputError(ExitCode::kIoError,
                    "cannot write '" + final_path_.string() + "': " + reason(error_number));
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) {
    ::close(std::exchange(descriptor_, -1));
  }
  if (!part_path_.empty()) {
    ::unlink(part_path_.c_str());
    part_path_.clear();
  }
  fill_ = 0;
}

}  // namespace sensotwin::robot
