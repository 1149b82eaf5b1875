// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "render/drawing.hpp"
#include "render/error.hpp"
#include "render/image.hpp"

namespace sensotwin::render {

enum class Backend : std::uint8_t {
  kAuto,    ///< OSMesa, and EGL where OSMesa is missing (Mesa dropped OSMesa in 25.1)
  kOsMesa,  ///< in-memory Mesa, no display, no GPU
  kEgl,     ///< EGL surfaceless: no display; takes a GPU where the driver offers one
};
[[nodiscard]] std::string_view name_of(Backend backend);

/// Draws triangles without a window. Both backends are opened at run time, so that a program starts where
/// one, or both, are not installed.
///
/// One context is for one thread at a time; several contexts may draw in several threads.
///
/// Speed: llvmpipe starts a thread for each core. For small pictures on few cores it is twice as fast with
/// LP_NUM_THREADS=1 in the environment, and draws the same bytes. The library does not touch the environment:
/// it belongs to the process, so main() decides (setenv before the first context).
class OffscreenContext {
 public:
  virtual ~OffscreenContext() = default;
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// "OSMesa: llvmpipe (LLVM 15.0.6, 128 bits), Mesa 22.3.6" for logs and PNG comments.
  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  /// Anti-aliased: 2x2 pixels of 4 samples each behind every pixel, where the driver has multisampling.
  /// \returns kBadView for a size outside 1 to kLargestSide_px, kBackendFailed with OpenGL's reason.
  [[nodiscard]] Rendered<Image> draw(const Drawing& drawing) { return do_draw(drawing); }

 protected:
  OffscreenContext() = default;
  void set_renderer(std::string renderer) { renderer_ = std::move(renderer); }

 private:
  virtual Rendered<Image> do_draw(const Drawing& drawing) = 0;
  std::string renderer_;
};

/// \returns kBackendMissing when the library is not installed, kBackendFailed when it gives no context.
[[nodiscard]] Rendered<std::unique_ptr<OffscreenContext>> make_context(Backend backend = Backend::kAuto);

/// The two makers behind make_context().
[[nodiscard]] Rendered<std::unique_ptr<OffscreenContext>> make_osmesa_context();
[[nodiscard]] Rendered<std::unique_ptr<OffscreenContext>> make_egl_context();

}  // namespace sensotwin::render
