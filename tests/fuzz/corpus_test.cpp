// SPDX-License-Identifier: MIT
// What the fuzzers found worth keeping, and what they found wrong, by every compiler.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "robot/base/random.hpp"
#include "tests/fuzz/fuzzers.hpp"

namespace sensotwin::fuzz {

/// By its name in the talk of a test.
void PrintTo(const Fuzzer& fuzzer,
             std::ostream* out);  // NOLINT(readability-identifier-naming): GoogleTest's name
void PrintTo(const Fuzzer& fuzzer, std::ostream* out) {
  *out << fuzzer.name;
}

namespace {

namespace fs = std::filesystem;

[[nodiscard]] std::vector<fs::path> files_of(const Fuzzer& fuzzer) {
  const fs::path folder = fs::path{SENSOTWIN_SOURCE_DIR} / "tests/fuzz/corpus" / fuzzer.name;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator{folder}) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

[[nodiscard]] robot::Bytes bytes_of(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return robot::Bytes(std::istreambuf_iterator<char>{file}, {});
}

class Corpus : public ::testing::TestWithParam<Fuzzer> {};

TEST_P(Corpus, HoldsTheProperties) {
  const auto files = files_of(GetParam());
  EXPECT_GE(files.size(), 10u) << "a corpus that is lost tests nothing";
  for (const fs::path& file : files) {
    EXPECT_NO_THROW(GetParam().run(bytes_of(file))) << file;
  }
}

TEST_P(Corpus, HoldsThemWithBytesChangedLostAndDoubled) {
  robot::RandomStream random = robot::RandomStream{5}.fork(GetParam().name);
  for (const fs::path& file : files_of(GetParam())) {
    robot::Bytes bytes = bytes_of(file);
    if (bytes.empty()) {
      continue;
    }
    const auto somewhere = [&] {
      return bytes.begin() +
             static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(bytes.size())));
    };
    *somewhere() = static_cast<std::uint8_t>(random.below(256));
    bytes.insert(somewhere(), *somewhere());
    bytes.erase(somewhere());
    EXPECT_NO_THROW(GetParam().run(bytes)) << file;
  }
}

TEST_P(Corpus, HoldsThemForNoBytesAtAll) {
  EXPECT_NO_THROW(GetParam().run({}));
}

INSTANTIATE_TEST_SUITE_P(Fuzzers, Corpus, ::testing::ValuesIn(kFuzzers),
                         [](const auto& each) { return std::string{each.param.name}; });

}  // namespace
}  // namespace sensotwin::fuzz
