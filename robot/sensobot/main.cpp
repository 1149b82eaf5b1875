// SPDX-License-Identifier: MIT
#include <ctime>
#include <iostream>

#include "robot/output/signals.hpp"
#include "robot/sensobot/application.hpp"

namespace {

using namespace sensotwin::robot;  // NOLINT(google-build-using-namespace): main is the namespace's guest

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::string text(sizeof "20260131T235959Z", '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc));
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  install_machine_signal_handlers();
  return as_int(run_sensobot({argv + 1, argv + argc}, {.out = std::cout, .err = std::cerr, .utc = utc_now}));
}
