// SPDX-License-Identifier: MIT
#include "twin/run/phase_twin.hpp"

#include "twin/run/phase_config.hpp"

namespace sensotwin::twin {
namespace {

robot::PhaseLinks rewired(const robot::PhaseLinks& links, const PhaseTwin::Rewiring& rewire) {
  return rewire ? rewire(links) : links;
}

robot::PhaseProgramConfig told(robot::PhaseProgramConfig config, const PhaseTwin::Retelling& retell) {
  if (retell) {
    retell(config);
  }
  return config;
}

}  // namespace

PhaseTwin::PhaseTwin(const Scene& scene, const Rewiring& rewire, const Retelling& retell)
    : random_(scene.seed),
      machine_(scene, random_),
      ceiling_(scene, random_),
      program_(rewired({machine_.serial(), ceiling_.reader().link(), machine_.floor_reader(),
                        machine_.sensor_board()},
                       rewire),
               told(phase_config_of(scene, ceiling_.world()), retell)) {}

void PhaseTwin::tick() {
  tick_world();
  tick_devices();
  tick_program();
}

void PhaseTwin::tick_world() {
  ceiling_.tick_world(machine_.tick_world());
}

void PhaseTwin::tick_devices() {
  machine_.tick_devices();
  ceiling_.tick_devices(now());
}

void PhaseTwin::tick_program() {
  program_.step(now());
  machine_.close_tick();
}

}  // namespace sensotwin::twin
