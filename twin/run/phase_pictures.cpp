// SPDX-License-Identifier: MIT
#include "twin/run/phase_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "render/offscreen_context.hpp"
#include "render/phase_charts.hpp"
#include "render/phase_pictures.hpp"
#include "render/png_writer.hpp"
#include "render/scene_picture.hpp"
#include "robot/output/output_error.hpp"
#include "robot/phase/control_surface.hpp"
#include "twin/run/phase_config.hpp"
#include "twin/run/scene_views.hpp"

namespace sensotwin::twin {
namespace {

template <class T>
T drawn(render::Rendered<T> result, std::string_view name) {
  if (!result) {
    throw robot::OutputError(
        robot::ExitCode::kCannotCreate,
        fmt::format("{}: not drawn: {}; --no-pictures runs without pictures", name, result.error().message));
  }
  return std::move(*result);
}

render::FuzzySetView set_view(std::string name, const robot::Trapezoid& set, int rule) {
  return {std::move(name),
          {{set.left_foot, 0.0}, {set.left_shoulder, 1.0}, {set.right_shoulder, 1.0}, {set.right_foot, 0.0}},
          rule};
}

/// The curve of a controller as it steers. Chosen: as many points as the picture has columns, nearly.
render::ControlCurveView curve_of(std::string name, const robot::FuzzyController& controller) {
  constexpr int kPoints = 801;
  render::ControlCurveView curve{std::move(name), {}};
  for (const auto& input : robot::control_surface(controller, kPoints).inputs) {
    curve.points.push_back({input.phase_difference_rad, input.turn_rate_radps});
  }
  return curve;
}

render::FuzzyControllerView controller_view(const Scene& scene, const robot::FuzzyController& controller) {
  const robot::FuzzySets& sets = controller.sets();
  render::FuzzyControllerView view;
  view.title = "Membership functions and control curve";
  view.subtitle = fmt::format("{}: Mamdani, min, max, centre of area", scene.name);
  view.inputs = {set_view("Neg", sets.negative_rad, 0), set_view("Zero", sets.zero_rad, 1),
                 set_view("Pos", sets.positive_rad, 2)};
  view.outputs = {set_view("CCW", sets.counter_clockwise_radps, 0), set_view("Zero", sets.straight_radps, 1),
                  set_view("CW", sets.clockwise_radps, 2)};
  view.curves.push_back(curve_of("this scene's sets", controller));
  for (const auto& [name, other] :
       {std::pair{"preset reproduction", robot::kReproductionSets}, {"preset tuned", robot::kTunedSets}}) {
    if (!(other == sets)) {
      view.curves.push_back(curve_of(name, robot::FuzzyController(other)));
    }
  }
  return view;
}

/// One run's pictures.
class PhasePainter {
 public:
  PhasePainter(const Scene& scene, const PhaseTwin& twin, const PhaseRecorder& recorder,
               const PathResult& result, robot::RunFolder& folder, const std::function<bool()>& may_go_on)
      : scene_(scene),
        twin_(twin),
        recorder_(recorder),
        result_(result),
        folder_(folder),
        may_go_on_(may_go_on) {}

  /// \returns false when it was told to stop
  bool draw_all() {
    const render::PhaseRunView run = run_view();
    save("path.png", drawn(render::draw_phase_sheet(run), "path.png").image);
    if (!may_go_on_()) {
      return false;
    }
    save("plan.png", drawn(render::draw_phase_plan(run), "plan.png").image);
    save("error.png", drawn(render::draw_tracking_error(run), "error.png").image);
    if (!may_go_on_()) {
      return false;
    }
    save("noise.png", drawn(render::draw_noise(recorder_.noise().view(scene_)), "noise.png").image);
    if (!may_go_on_()) {
      return false;
    }
    if (const robot::FuzzyMission* fuzzy = twin_.program().fuzzy()) {
      save("controller.png",
           drawn(render::draw_controller(controller_view(scene_, fuzzy->controller())), "controller.png")
               .image);
    } else if (!run.estimates.empty()) {
      save("estimates.png", drawn(render::draw_estimates_sheet(run), "estimates.png").image);
    }
    if (!may_go_on_()) {
      return false;
    }
    const auto context = drawn(render::make_context(), "oblique.png");
    renderer_ = context->renderer();
    save("oblique.png", drawn(render::draw_oblique_view(*context, space_view()), "oblique.png").image);
    return may_go_on_();
  }

 private:
  void save(const std::string& name, const render::Image& image) {
    render::PngText text;
    text.comment = render::provenance(scene_.name, scene_.seed, renderer_);
    const auto bytes = drawn(render::encode_png(image, text), name);
    folder_.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  [[nodiscard]] std::string figures() const {
    return fmt::format("{} controller, radio {}: {} tags reached in {:.0f} s, error {:+.1f} to {:+.1f} cm",
                       result_.controller, scene_.world.radio->radio.profile, result_.tags_reached,
                       60.0 * result_.minutes, 100.0 * result_.error_min_m, 100.0 * result_.error_max_m);
  }

  [[nodiscard]] render::PhaseRunView run_view() const {
    render::PhaseRunView view = plan_of(scene_, twin_.world().X_WF());
    view.subtitle = figures();
    for (const world::CeilingTag& tag : scene_.world.radio->tags) {
      view.tags.push_back({tag.name, tag.at_m, !tag.present});
    }
    view.ideal_m = recorder_.path().points_m();
    view.driven = recorder_.driven();
    view.end = twin_.world().X_WR();
    view.segments = recorder_.segments();
    view.errors = recorder_.errors();
    view.rmse_m = result_.rmse_m;
    view.estimates = recorder_.estimates();
    return view;
  }

  [[nodiscard]] render::SceneView space_view() const {
    render::SceneView view = view_of(scene_, twin_.world().tags(), twin_.world().X_WF());
    view.subtitle = figures();
    view.trajectory = recorder_.driven();
    view.ideal_path_m = recorder_.path().points_m();
    render::RobotView robot{twin_.world().X_WR(), scene_.robot.base.radius_m, scene_.robot.base.height_m};
    for (const world::AntennaDescription& antenna : scene_.world.radio->antennas) {
      robot.antennas.push_back({antenna.at_m.head<2>(), antenna.at_m.z()});
    }
    view.robot = robot;
    for (const world::CeilingTag& tag : scene_.world.radio->tags) {
      if (tag.present) {
        view.ceiling_tags.push_back({tag.at_m, tag.height_m, tag.name});
      }
    }
    return view;
  }

  const Scene& scene_;
  const PhaseTwin& twin_;
  const PhaseRecorder& recorder_;
  const PathResult& result_;
  robot::RunFolder& folder_;
  const std::function<bool()>& may_go_on_;
  std::string renderer_{"cairo"};
};

}  // namespace

bool draw_phase_run(const Scene& scene, const PhaseTwin& twin, const PhaseRecorder& recorder,
                    const PathResult& result, robot::RunFolder& folder,
                    const std::function<bool()>& may_go_on) {
  return PhasePainter(scene, twin, recorder, result, folder, may_go_on).draw_all();
}

}  // namespace sensotwin::twin
