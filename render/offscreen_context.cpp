// SPDX-License-Identifier: MIT
#include "render/offscreen_context.hpp"

namespace sensotwin::render {

std::string_view name_of(Backend backend) {
  switch (backend) {
    case Backend::kAuto:
      return "auto";
    case Backend::kOsMesa:
      return "osmesa";
    case Backend::kEgl:
      return "egl";
  }
  return "auto";
}

Rendered<std::unique_ptr<OffscreenContext>> make_context(Backend backend) {
  if (backend == Backend::kOsMesa) {
    return make_osmesa_context();
  }
  if (backend == Backend::kEgl) {
    return make_egl_context();
  }
  auto first = make_osmesa_context();
  if (first) {
    return first;
  }
  auto second = make_egl_context();
  if (second) {
    return second;
  }
  return Unexpected{RenderError{first.error().kind, first.error().message + "; " + second.error().message}};
}

}  // namespace sensotwin::render
