// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <ostream>
#include <sstream>
#include <thread>

#include "robot/output/output_file.hpp"
#include "robot/output/signals.hpp"
#include "twin/cli/deed_support.hpp"
#include "twin/cli/deeds.hpp"
#include "twin/run/mapping_run.hpp"
#include "twin/validate/junit.hpp"
#include "twin/validate/report_pictures.hpp"
#include "twin/validate/seed_runs.hpp"

namespace sensotwin::twin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSeedsFile = "seeds.csv";
/// Seconds between two writings of seeds.csv. Chosen: what a power cut may cost.
constexpr double kSavePeriod_s = 5.0;

bool may_go_on() {
  return !robot::pending_interruption();
}

void remove_or_throw(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) {
    throw CommandError(robot::ExitCode::kCannotCreate,
                       fmt::format("{}: cannot be replaced: {}", path.string(), error.message()));
  }
}

/// The folder as the options want it: new, emptied of an earlier validation, or as it is.
robot::RunFolder open_folder(const fs::path& path, const ValidateOptions& options) {
  const bool earlier = fs::exists(path / kSeedsFile);
  if (earlier && !options.resume && !options.force) {
    throw CommandError(
        robot::ExitCode::kCannotCreate,
        fmt::format("{}: holds an earlier validation; --resume goes on with it, --force begins anew",
                    path.string()));
  }
  // A leftover .scratch of a killed validation is no reason to refuse the folder.
  const bool ours = earlier || (options.resume && fs::exists(path / ".scratch"));
  robot::RunFolder folder(path, ours || options.force ? robot::Existing::kReplace : robot::Existing::kRefuse);
  if (earlier) {
    // An old verdict, its charts and its worst seeds never lie beside new data.
    for (const char* stale : {"report.json", "distributions", "worst"}) {
      remove_or_throw(path / stale);
    }
  }
  if (earlier && !options.resume) {
    remove_or_throw(path / kSeedsFile);
  }
  return folder;
}

SeedTable seeds_in(const fs::path& file, const Origin& origin) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return {};
  }
  std::ostringstream text;
  text << in.rdbuf();
  try {
    return seed_table_from(text.str(), origin, file.string());
  } catch (const SeedTableError& error) {
    throw CommandError(robot::ExitCode::kInvalidData, fmt::format("{}; --force begins anew", error.what()));
  }
}

/// Where a validation goes when nobody said where: a folder of its own, also for the second one of a second.
fs::path new_folder(const std::string& scene, const std::string& utc) {
  const fs::path wanted = robot::default_validation_folder(scene, utc);
  fs::path path = wanted;
  for (int i = 2; fs::exists(path); ++i) {
    path = wanted.string() + fmt::format("-{}", i);
  }
  return path;
}

/// Runs what is missing, showing how far it is and saving now and then. \returns whether all is there
bool run_missing(const Scene& scene, const ValidateOptions& options, Context& context,
                 robot::RunFolder& folder, const Origin& origin, SeedTable& table) {
  const bool loud = context.verbosity != Verbosity::kQuiet;
  Progress progress(context.talk, context.progress, scene.name, "seeds");
  const double begun = context.wall_s();
  const std::size_t before = runs_of(table, options.seeds).size();
  const auto total = static_cast<double>(options.seeds.size() - before);
  ProgressState state{.done = 0.0, .total = total, .wall_s = 0.0, .note = {}};
  double saved_s = begun;
  const auto ran = [&](const SeedTable& so_far, int there) {
    const double now = context.wall_s();
    state.done = there - static_cast<double>(before);
    state.wall_s = now - begun;
    if (loud) {
      progress.update(state);
    }
    if (now - saved_s > kSavePeriod_s) {
      saved_s = now;
      folder.write(kSeedsFile, to_csv(so_far, origin));
    }
  };
  const auto save = [&] { folder.write(kSeedsFile, to_csv(table, origin)); };
  if (before > 0) {
    context.say(fmt::format("{} of {} seeds are in {} already", before, options.seeds.size(),
                            (folder.path() / kSeedsFile).string()));
  }
  bool all = false;
  try {
    all = run_seeds(
        scene,
        {.seeds = options.seeds,
         .jobs = options.jobs > 0 ? options.jobs
                                  : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
         .scratch = folder.path() / ".scratch",
         .scene_as_given = options.choice.scene.string(),
         .keep_going = may_go_on,
         .ran = ran},
        table);
  } catch (...) {
    save();
    throw;
  }
  if (loud && total > 0.0) {
    progress.finish(state);
  }
  save();
  return all;
}

Validation validation_of(const Scene& scene, const ValidateOptions& options, const SeedTable& table,
                         const Origin& origin) {
  Validation validation;
  validation.scene = options.choice.scene.string();
  validation.name = scene.name;
  validation.scene_hash = origin.scene_hash;
  validation.variant = scene.variant;
  validation.set = options.choice.set;
  validation.seeds = options.seeds;
  validation.runs = runs_of(table, options.seeds);
  validation.options = {
      .confidence = options.confidence,
      .rates = options.intervals == "wilson" ? RateMethod::kWilson : RateMethod::kClopperPearson,
      .rate = options.rate};
  validation.judged = judge_seeds(scene, validation.runs, validation.options);
  validation.worst = worst_seeds(validation.judged, validation.runs, options.worst);
  return validation;
}

/// Names that `expect:` may not use are found before the runs, and so is a JUnit file that cannot be written.
void check_before(const Scene& scene, const ValidateOptions& options, const Context& context) {
  if (const auto complaint = complain_about(limits_of(scene))) {
    throw CommandError(robot::ExitCode::kInvalidData, fmt::format("{}: {}", scene.file, *complaint));
  }
  if (scene.expect.empty()) {
    context.warn(fmt::format("{}: nothing is expected (expect:), so nothing can be missed", scene.file));
  }
  if (options.junit) {
    // Replaced without being asked, as by every other program that writes JUnit XML.
    const robot::OutputFile writable(*options.junit);
  }
}

}  // namespace

robot::ExitCode validate_deed(const ValidateOptions& options, Context& context) {
  if (options.force && options.resume) {
    throw CommandError(robot::ExitCode::kWrongCommandLine,
                       "--force begins anew, --resume goes on: one of them");
  }
  const Scene scene = scene_of(options.choice);
  check_before(scene, options, context);
  const Origin origin{scene_hash_of(scene), file_hash_of("/proc/self/exe")};
  const fs::path path = options.out ? *options.out : new_folder(scene.name, context.utc());
  // Read before anything is removed: whoever cannot go on finds the folder as it was.
  SeedTable table;
  if (options.resume && fs::exists(path / kSeedsFile)) {
    table = seeds_in(path / kSeedsFile, origin);
  }
  robot::RunFolder folder = open_folder(path, options);
  const bool all = run_missing(scene, options, context, folder, origin, table);
  const Validation validation = validation_of(scene, options, table, origin);
  folder.write("report.json", to_json(validation));
  if (options.junit) {
    write_file(*options.junit, to_junit(validation), true);
  }
  context.out << (context.json ? to_json(validation) : to_table(validation));
  if (all && options.pictures && !validation.worst.empty()) {
    context.say(
        fmt::format("running the worst seeds again, with pictures: {}", seeds_text(validation.worst)));
  }
  const bool drawn = all && (!options.pictures || (draw_distributions(validation, folder, may_go_on) &&
                                                   run_worst_again(scene, validation, folder, may_go_on)));
  context.say(fmt::format("report in {}", path.string()));
  if (!all || !drawn) {
    context.say("interrupted; --resume with the same --out goes on");
    return robot::ExitCode::kTryAgain;
  }
  return accepted(validation.judged) ? robot::ExitCode::kDone : robot::ExitCode::kNotAccepted;
}

}  // namespace sensotwin::twin
