// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/distribution_chart.hpp"
#include "robot/output/run_folder.hpp"
#include "twin/validate/report.hpp"

namespace sensotwin::twin {

/// A figure's distribution over the seeds with all its thresholds and their intervals.
/// \pre validation.runs is not empty, and each has the figure
[[nodiscard]] render::DistributionChart distribution_of(const Validation& validation,
                                                        const std::string& figure);

/// distributions/<figure>.png for each figure that is judged and that all runs have.
/// \param may_go_on  asked between charts  \returns false when it said no  \throws OutputError
[[nodiscard]] bool draw_distributions(const Validation& validation, robot::RunFolder& folder,
                                      const std::function<bool()>& may_go_on);

/// Runs validation.worst again, with pictures, into worst/seed_<N>/ of the folder.
/// \param may_go_on  asked all the time  \returns false when it said no
/// \throws OutputError; std::logic_error when a run does not repeat its state hash
[[nodiscard]] bool run_worst_again(const Scene& scene, const Validation& validation,
                                   const robot::RunFolder& folder, const std::function<bool()>& may_go_on);

}  // namespace sensotwin::twin
