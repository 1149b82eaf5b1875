// SPDX-License-Identifier: MIT
#include "twin/cli/application.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "robot/output/output_error.hpp"
#include "twin/cli/commands.hpp"

namespace sensotwin::twin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A command line, what it asked for, and what the user saw.
struct Desk {
  robot::ExitCode call(const std::vector<std::string>& arguments) {
    const std::vector<Command> commands{
        make_run_command([this](const RunOptions& o, Context& c) { return keep(run, o, c); }),
        make_show_command([this](const ShowOptions& o, Context& c) { return keep(show, o, c); }),
        make_render_command([this](const RenderOptions& o, Context& c) { return keep(render, o, c); }),
        make_import_command([this](const ImportOptions& o, Context& c) { return keep(import, o, c); }),
        make_epsilon_command([this](const EpsilonOptions& o, Context& c) { return keep(epsilon, o, c); }),
    };
    return run_application(arguments, commands,
                           {.out = out,
                            .err = err,
                            .err_is_terminal = err_is_terminal,
                            .no_color = no_color,
                            .wall_s = [] { return 0.0; },
                            .utc = [] { return std::string{"20260131T235959Z"}; }});
  }
  template <class Options>
  robot::ExitCode keep(Options& kept, const Options& given, Context& context) {
    kept = given;
    json = context.json;
    context.say("said");
    context.say_more("said more");
    return deed(context);
  }

  std::ostringstream out;
  std::ostringstream err;
  bool err_is_terminal{false};
  bool no_color{false};
  std::function<robot::ExitCode(Context&)> deed = [](Context&) { return robot::ExitCode::kDone; };
  RunOptions run;
  ShowOptions show;
  RenderOptions render;
  ImportOptions import;
  EpsilonOptions epsilon;
  bool json{false};
};

TEST(CommandLine, HandsSceneSeedAndChangesToTheRun) {
  Desk desk;
  EXPECT_EQ(desk.call({"run", "--set", "a.b=1", "house.yaml", "--seed", "8", "--set", "c=x=y", "--out", "o",
                       "--force", "--trace-every", "3", "--no-pictures", "--json"}),
            robot::ExitCode::kDone)
      << desk.err.str();
  EXPECT_EQ(desk.run.choice.scene, "house.yaml");
  EXPECT_EQ(desk.run.choice.seed, 8u);
  EXPECT_THAT(desk.run.choice.set, ElementsAre("a.b=1", "c=x=y"));
  EXPECT_EQ(desk.run.out, "o");
  EXPECT_TRUE(desk.run.force);
  EXPECT_EQ(desk.run.trace_every, 3);
  EXPECT_FALSE(desk.run.pictures);
  EXPECT_TRUE(desk.json);
}

TEST(CommandLine, LeavesSeedAndFolderToTheSceneWhenNotGiven) {
  Desk desk;
  EXPECT_EQ(desk.call({"run", "house.yaml"}), robot::ExitCode::kDone);
  EXPECT_EQ(desk.run.choice.seed, std::nullopt);
  EXPECT_EQ(desk.run.out, std::nullopt);
  EXPECT_TRUE(desk.run.pictures);
}

TEST(CommandLine, TakesSeedsOfSixtyFourBitsInDecimalAndHexadecimal) {
  Desk desk;
  EXPECT_EQ(desk.call({"run", "s", "--seed", "18446744073709551615"}), robot::ExitCode::kDone);
  EXPECT_EQ(desk.run.choice.seed, 18446744073709551615u);
  EXPECT_EQ(desk.call({"run", "s", "--seed", "0xff"}), robot::ExitCode::kDone);
  EXPECT_EQ(desk.run.choice.seed, 255u);
  EXPECT_EQ(desk.call({"run", "s", "--seed", "010"}), robot::ExitCode::kDone);
  EXPECT_EQ(desk.run.choice.seed, 10u);
}

TEST(CommandLine, RefusesWhatIsNoSeed) {
  for (const char* text : {"-1", "1.5", "x", "", "0x", "18446744073709551616"}) {
    Desk desk;
    EXPECT_EQ(desk.call({"run", "s", std::string{"--seed="} + text}), robot::ExitCode::kWrongCommandLine)
        << text;
  }
}

TEST(CommandLine, RefusesAChangeWithoutKeyOrValue) {
  for (const char* text : {"novalue", "=1"}) {
    Desk desk;
    EXPECT_EQ(desk.call({"show", "s", "--set", text}), robot::ExitCode::kWrongCommandLine);
    EXPECT_THAT(desk.err.str(), HasSubstr("is not of the form key.path=value"));
  }
}

TEST(CommandLine, TakesASceneThatIsCalledLikeACommand) {
  Desk desk;
  EXPECT_EQ(desk.call({"run", "show"}), robot::ExitCode::kDone) << desk.err.str();
  EXPECT_EQ(desk.run.choice.scene, "show");
}

TEST(CommandLine, HandsViewWidthAndRendererToRender) {
  Desk desk;
  EXPECT_EQ(desk.call({"render", "s", "--view", "oblique", "--width-px", "800", "--renderer", "egl", "--out",
                       "p.png"}),
            robot::ExitCode::kDone);
  EXPECT_EQ(desk.render.view, "oblique");
  EXPECT_EQ(desk.render.width_px, 800);
  EXPECT_EQ(desk.render.renderer, "egl");
  EXPECT_EQ(desk.call({"render", "s", "--view", "below"}), robot::ExitCode::kWrongCommandLine);
}

TEST(CommandLine, HandsMapAndTileToImport) {
  Desk desk;
  EXPECT_EQ(desk.call({"import", "flat.yaml", "--tile-m", "0.5", "--out", "scene.yaml"}),
            robot::ExitCode::kDone);
  EXPECT_EQ(desk.import.map, "flat.yaml");
  EXPECT_EQ(desk.import.tile_m, 0.5);
  EXPECT_EQ(desk.call({"import", "flat.yaml", "--tile-m", "nan"}), robot::ExitCode::kWrongCommandLine);
}

TEST(CommandLine, HandsExplorersMapsAndJobsToTheStudy) {
  Desk desk;
  EXPECT_EQ(desk.call({"epsilon", "--explorer", "idfm", "--explorer", "sweep", "--maps", "10", "--jobs", "2",
                       "--knowledge", "bump"}),
            robot::ExitCode::kDone);
  EXPECT_THAT(desk.epsilon.explorers, ElementsAre("idfm", "sweep"));
  EXPECT_EQ(desk.epsilon.maps_per_cell, 10);
  EXPECT_EQ(desk.epsilon.jobs, 2);
  EXPECT_EQ(desk.epsilon.knowledge, "bump");
}

TEST(CommandLine, NamesTheMissingScene) {
  Desk desk;
  EXPECT_EQ(desk.call({"run"}), robot::ExitCode::kWrongCommandLine);
  EXPECT_THAT(desk.err.str(), HasSubstr("SCENE is required"));
  EXPECT_THAT(desk.err.str(), HasSubstr("'twin run --help'"));
}

TEST(CommandLine, BlamesTheMistypedOptionAndNotWhatIsMissingBecauseOfIt) {
  Desk desk;
  EXPECT_EQ(desk.call({"run", "s", "--sed", "8"}), robot::ExitCode::kWrongCommandLine);
  EXPECT_THAT(desk.err.str(), HasSubstr("unknown option '--sed' (did you mean '--seed'?)"));
}

TEST(CommandLine, SuggestsTheNearestCommand) {
  Desk desk;
  EXPECT_EQ(desk.call({"rnu", "s"}), robot::ExitCode::kWrongCommandLine);
  EXPECT_THAT(desk.err.str(), HasSubstr("unknown command 'rnu' (did you mean 'run'?)"));
}

TEST(CommandLine, SuggestsNothingForAWordThatIsNearNone) {
  Desk desk;
  EXPECT_EQ(desk.call({"vacuum"}), robot::ExitCode::kWrongCommandLine);
  EXPECT_THAT(desk.err.str(), Not(HasSubstr("did you mean")));
}

TEST(CommandLine, OpensEveryHelpWithExamplesThatAreThatCommands) {
  for (const char* command : {"run", "show", "render", "import", "epsilon"}) {
    Desk desk;
    EXPECT_EQ(desk.call({command, "--help"}), robot::ExitCode::kDone);
    const std::string help = desk.out.str();
    EXPECT_TRUE(help.starts_with(std::string{"twin "} + command + ": ")) << help;
    EXPECT_LT(help.find("Examples:\n  twin " + std::string{command}), help.find("Usage:")) << help;
    EXPECT_THAT(help, HasSubstr("Global options:"));
    EXPECT_THAT(desk.err.str(), IsEmpty());
  }
}

TEST(Verbosity, SaysNothingWhenQuietAndMoreWhenVerbose) {
  Desk normal;
  Desk quiet;
  Desk verbose;
  (void)normal.call({"show", "s"});
  (void)quiet.call({"show", "s", "-q"});
  (void)verbose.call({"-v", "show", "s"});
  EXPECT_EQ(normal.err.str(), "said\n");
  EXPECT_EQ(quiet.err.str(), "");
  EXPECT_EQ(verbose.err.str(), "said\nsaid more\n");
}

TEST(Color, IsForTerminalsUnlessNoColorIsSetOrTheUserDecides) {
  const auto coloured = [](bool terminal, bool no_color, const std::vector<std::string>& more) {
    Desk desk;
    desk.err_is_terminal = terminal;
    desk.no_color = no_color;
    desk.deed = [](Context& context) {
      context.warn("careful");
      return robot::ExitCode::kDone;
    };
    std::vector<std::string> arguments{"show", "s"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    (void)desk.call(arguments);
    return desk.err.str().find('\x1b') != std::string::npos;
  };
  EXPECT_TRUE(coloured(true, false, {}));
  EXPECT_FALSE(coloured(false, false, {}));
  EXPECT_FALSE(coloured(true, true, {}));
  EXPECT_FALSE(coloured(true, false, {"--no-color"}));
  EXPECT_FALSE(coloured(true, false, {"--color", "never"}));
  EXPECT_TRUE(coloured(false, true, {"--color", "always"}));
}

TEST(Failures, EndWithTheCodeThatTheyCarryAndOneLine) {
  const auto ending = [](std::function<robot::ExitCode(Context&)> deed) {
    Desk desk;
    desk.deed = std::move(deed);
    const robot::ExitCode code = desk.call({"run", "s", "-q"});
    return std::make_pair(robot::as_int(code), desk.err.str());
  };
  EXPECT_EQ(ending([](Context&) { return robot::ExitCode::kNotAccepted; }), std::make_pair(1, std::string{}));
  EXPECT_EQ(ending([](Context&) -> robot::ExitCode {
              throw robot::OutputError(robot::ExitCode::kCannotCreate, "cannot create 'x'");
            }),
            std::make_pair(73, std::string{"error: cannot create 'x'\n"}));
  EXPECT_EQ(ending([](Context&) -> robot::ExitCode {
              throw CommandError(robot::ExitCode::kInputMissing, "no 'y'");
            }),
            std::make_pair(66, std::string{"error: no 'y'\n"}));
  EXPECT_EQ(ending([](Context&) -> robot::ExitCode { throw std::logic_error("oops"); }),
            std::make_pair(70, std::string{"error: internal: oops\n"}));
}

TEST(Failures, IncludeResultsThatDidNotReachStdout) {
  Desk desk;
  desk.deed = [](Context& context) {
    context.out.setstate(std::ios::badbit);
    return robot::ExitCode::kDone;
  };
  EXPECT_EQ(desk.call({"run", "s"}), robot::ExitCode::kIoError);
}

TEST(Doctor, IsUnhealthyOnlyWhenSomethingRequiredIsMissing) {
  const auto examine = [](bool required) {
    std::ostringstream out;
    std::ostringstream err;
    const std::vector<Command> commands{make_doctor_command({{"screen", required,
                                                              [] {
                                                                return ProbeResult{false, "none found"};
                                                              }},
                                                             {"paint", true, []() -> ProbeResult {
                                                                return {true, "plenty"};
                                                              }}})};
    const robot::ExitCode code =
        run_application({"doctor"}, commands, {.out = out, .err = err, .wall_s = {}, .utc = {}});
    return std::make_pair(code, out.str());
  };
  EXPECT_EQ(examine(true).first, robot::ExitCode::kUnavailable);
  EXPECT_THAT(examine(true).second, HasSubstr("missing  screen             none found\nok       paint"));
  EXPECT_EQ(examine(false).first, robot::ExitCode::kDone);
  EXPECT_THAT(examine(false).second, HasSubstr("absent   screen"));
}

TEST(Doctor, ReportsAProbeThatThrewAsMissing) {
  std::ostringstream out;
  std::ostringstream err;
  const std::vector<Command> commands{make_doctor_command(
      {{"screen", true, []() -> ProbeResult { throw std::runtime_error("driver broke"); }}})};
  EXPECT_EQ(run_application({"doctor"}, commands, {.out = out, .err = err, .wall_s = {}, .utc = {}}),
            robot::ExitCode::kUnavailable);
  EXPECT_THAT(out.str(), HasSubstr("driver broke"));
}

}  // namespace
}  // namespace sensotwin::twin
