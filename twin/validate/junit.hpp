// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "twin/validate/report.hpp"

namespace sensotwin::twin {

/// The validation as JUnit XML (the form that Jenkins and GitLab read): one suite, one case per threshold. A
/// missed or open one is a failure whose body names the failing seeds and the commands that repeat them; when
/// seeds are missing, every case is an error, so that half a validation is never green.
/// No times in it: equal validations, equal bytes.
[[nodiscard]] std::string to_junit(const Validation& validation);

}  // namespace sensotwin::twin
