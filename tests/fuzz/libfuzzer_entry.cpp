// SPDX-License-Identifier: MIT
// One fuzzer of fuzzers.hpp, named by SENSOTWIN_FUZZER, as a libFuzzer program.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzzers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);  // its name is libFuzzer's

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sensotwin::fuzz::SENSOTWIN_FUZZER({data, size});
  return 0;
}
