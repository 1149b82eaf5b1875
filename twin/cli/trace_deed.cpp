// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>
#include <thread>

#include "robot/output/signals.hpp"
#include "robot/telemetry/web/web_error.hpp"
#include "robot/telemetry/web/web_server.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/trace/trace_site.hpp"

namespace sensotwin::twin {
namespace {

/// A folder of ours among the system's temporary ones, gone with us.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "twin-trace-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) {
      throw CommandError(robot::ExitCode::kCannotCreate,
                         fmt::format("cannot create a temporary folder '{}'", pattern));
    }
    path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

bool names_a_file(const std::filesystem::path& out) {
  const std::string extension = out.extension().string();
  return (extension == ".yaml" || extension == ".yml") && !std::filesystem::is_directory(out);
}

std::filesystem::path folder_of(const TraceOptions& asked) {
  if (asked.out) {
    return names_a_file(*asked.out) ? asked.out->parent_path() : *asked.out;
  }
  return asked.plan ? asked.plan->parent_path() : std::filesystem::path{};
}

void open_browser(const std::string& url, Context& context) {
  std::string program = "xdg-open";
  std::string address = url;
  char* const arguments[]{program.data(), address.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) != 0) {
    context.warn("--open: xdg-open is not there; open the address above by hand");
  }
}

}  // namespace

robot::ExitCode trace_deed(const TraceOptions& asked, Context& context) {
  robot::WebServerOptions web;
  const auto address = robot::web_address(asked.listen);
  if (!address) {
    throw CommandError(robot::ExitCode::kWrongCommandLine,
                       fmt::format("--listen: '{}' is not of the form host:port", asked.listen));
  }
  web.address = *address;
  web.body_bytes = kTraceBodyMax;
  web.request_time = std::chrono::seconds{60};  // chosen: the largest picture over a slow wireless network
  const ScratchFolder scratch;
  TraceSession session(folder_of(asked), scratch.path());
  try {
    if (asked.plan) {
      session.open_operand(*asked.plan);
    }
    if (asked.out && names_a_file(*asked.out)) {
      const std::string name = asked.out->filename().string();
      if (!is_file_name(name)) {
        throw CommandError(robot::ExitCode::kWrongCommandLine,
                           fmt::format("--out: '{}' is no name that the page could save", name));
      }
      session.suggest_hallways_file(name);
    }
    const robot::WebServer server(trace_site(session), web);
    if (context.json) {
      context.out << nlohmann::json{{"url", server.url()}, {"folder", session.folder().string()}}.dump()
                  << std::endl;
    } else {
      context.out << server.url() << std::endl;
    }
    context.say(fmt::format("Open this address in a browser; files go to '{}'. Ctrl-C ends it.",
                            session.folder().string()));
    if (asked.open) {
      open_browser(server.url(), context);
    }
    while (!robot::pending_interruption()) {
      // Chosen: Ctrl-C is obeyed at once, as far as a person can tell, and nothing is burnt.
      std::this_thread::sleep_for(std::chrono::milliseconds{50});
    }
  } catch (const robot::LoadError& error) {
    throw CommandError(static_cast<robot::ExitCode>(error.exit_code()), error.what(), true);
  } catch (const robot::WebError& error) {
    throw CommandError(robot::ExitCode::kUnavailable, error.what());
  }
  return *robot::pending_interruption();
}

}  // namespace sensotwin::twin
