// SPDX-License-Identifier: MIT
#include "robot/replay/journal_file.hpp"

#include <string>

#include "robot/config/problem.hpp"
#include "robot/config/text_file.hpp"
#include "robot/journal/journal_reader.hpp"
#include "robot/output/output_error.hpp"

namespace sensotwin::robot {

JournalFile::JournalFile(const std::optional<std::filesystem::path>& file, std::string_view robot_file) {
  if (!file) {
    return;
  }
  stream_.open(*file, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw OutputError(ExitCode::kCannotCreate, "cannot create '" + file->string() + "'");
  }
  writer_.emplace(
      [this](ByteView bytes) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are characters to a stream
        stream_.write(reinterpret_cast<const char*>(bytes.data()),
                      static_cast<std::streamsize>(bytes.size()));
        return static_cast<bool>(stream_.flush());
      },
      robot_file);
}

Journal journal_in(const std::filesystem::path& file) {
  const std::string text = read_text_file(file, "journal");
  auto journal = read_journal(Bytes(text.begin(), text.end()));
  if (!journal) {
    throw LoadError({{{file.string(), 0, 0},
                      "",
                      "is no journal: " + journal.error(),
                      "expected what `sensobot run` or `twin run --journal` writes"}},
                    kExitInvalid);
  }
  return std::move(*journal);
}

}  // namespace sensotwin::robot
