// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>

#include "twin/cli/commands.hpp"
#include "twin/cli/version.hpp"

namespace sensotwin::twin {
namespace {

/// Pictures ask cairo for this family; fontconfig would silently give another.
constexpr const char* kFontFamily = "DejaVu Sans";

ProbeResult look_for_font() {
  // A configuration of our own, since the library never frees its global one.
  const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfigAndFonts(),
                                                                     FcConfigDestroy);
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(), FcPatternDestroy);
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(kFontFamily));
  FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result{};
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> match(
      FcFontMatch(config.get(), pattern.get(), &result), FcPatternDestroy);
  FcChar8* family = nullptr;
  if (match == nullptr || FcPatternGetString(match.get(), FC_FAMILY, 0, &family) != FcResultMatch) {
    return {false, "no font at all; install fonts-dejavu-core"};
  }
  const std::string found = reinterpret_cast<const char*>(family);
  return found == kFontFamily
             ? ProbeResult{true, found}
             : ProbeResult{false, "would be replaced by " + found + "; install fonts-dejavu-core"};
}

ProbeResult look_for_terminals() {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0) {
    return {false, "no pseudo-terminal; is /dev/pts mounted?"};
  }
  ::close(terminal);
  return {true, "can be opened"};
}

ProbeResult look_for_card_service() {
  std::error_code error;
  // The socket's place is compiled into pcsc-lite.
  const bool there = std::filesystem::exists("/run/pcscd/pcscd.comm", error);
  return {there, there ? "pcscd is running" : "pcscd is not running; only real card readers need it"};
}

}  // namespace

std::vector<Probe> machine_probes() {
  std::vector<Probe> probes;
  for (const auto& [name, version] : library_versions()) {
    probes.push_back({name, true, [version = version] { return ProbeResult{true, version}; }});
  }
  probes.push_back({"font", true, look_for_font});
  probes.push_back({"processors", false, [] {
                      return ProbeResult{true, fmt::format("{}", std::thread::hardware_concurrency())};
                    }});
  probes.push_back({"pseudo-terminals", false, look_for_terminals});
  probes.push_back({"card service", false, look_for_card_service});
  return probes;
}

}  // namespace sensotwin::twin
