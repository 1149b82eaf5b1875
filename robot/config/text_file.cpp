// SPDX-License-Identifier: MIT
#include "robot/config/text_file.hpp"

#include <cstdint>
#include <fstream>
#include <system_error>

#include "robot/config/problem.hpp"

namespace sensotwin::robot {

std::string read_text_file(const std::filesystem::path& file, const std::string& what) {
  const Place place{file.string(), 0, 0};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    throw LoadError({{place, "", "no such file", "expected a " + what}}, kExitMissing);
  }
  if (std::filesystem::is_directory(status)) {
    throw LoadError({{place, "", "is a folder", "expected a " + what + " file"}}, kExitInvalid);
  }
  // Chosen: the largest picture that is read, 16384 x 16384 pixels of 2 bytes, is half of this.
  constexpr std::uintmax_t kBytesMax = 1u << 30;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > kBytesMax) {
    throw LoadError({{place, "", "is larger than 1 GiB", "expected a " + what}}, kExitInvalid);
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw LoadError({{place, "", "cannot be read", "expected a " + what + " that you may read"}},
                    kExitMissing);
  }
  // A file that is no file, such as a pipe, has no size: read until it ends or is too long.
  std::string text;
  char buffer[65536];
  while (stream.read(buffer, sizeof buffer) || stream.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kBytesMax) {
      throw LoadError({{place, "", "is larger than 1 GiB", "expected a " + what}}, kExitInvalid);
    }
  }
  return text;
}

}  // namespace sensotwin::robot
