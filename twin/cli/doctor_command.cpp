// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

#include "twin/cli/commands.hpp"

namespace sensotwin::twin {
namespace {

ProbeResult look_safely(const Probe& probe) {
  try {
    return probe.look();
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

std::string_view status_of(const Probe& probe, const ProbeResult& result) {
  return result.ok ? "ok" : probe.required ? "missing" : "absent";
}

robot::ExitCode examine(const std::vector<Probe>& probes, Context& context) {
  bool healthy = true;
  auto json = nlohmann::ordered_json::array();
  for (const Probe& probe : probes) {
    const ProbeResult result = look_safely(probe);
    healthy = healthy && (result.ok || !probe.required);
    json.push_back({{"name", probe.name},
                    {"status", status_of(probe, result)},
                    {"required", probe.required},
                    {"detail", result.detail}});
    if (!context.json) {
      context.out << fmt::format("{:<8} {:<18} {}\n", status_of(probe, result), probe.name, result.detail);
    }
  }
  if (context.json) {
    const nlohmann::ordered_json report{{"healthy", healthy}, {"probes", json}};
    context.out << report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  }
  if (!healthy) {
    throw CommandError(robot::ExitCode::kUnavailable,
                       "something that the twin needs is missing; script/bootstrap installs it");
  }
  return robot::ExitCode::kDone;
}

}  // namespace

Command make_doctor_command(std::vector<Probe> probes) {
  return {
      .name = "doctor",
      .summary = "check whether this machine has what the twin needs",
      .examples = "twin doctor\ntwin doctor --json",
      .set_up = [](CLI::App&) {},
      .run = [probes = std::move(probes)](Context& context) { return examine(probes, context); },
  };
}

}  // namespace sensotwin::twin
