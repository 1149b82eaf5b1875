// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "render/drawing.hpp"
#include "render/error.hpp"
#include "render/image.hpp"

namespace sensotwin::render {

using GlFunction = void (*)();
/// Address of an OpenGL function by its name, or null.
using GlLoader = std::function<GlFunction(const char*)>;

/// The OpenGL half that both backends share: compatibility profile, fixed functions, one frame buffer object.
/// Every function is called through the pointer its own backend gave, so that libOSMesa and libEGL can live
/// in one process.
class GlRenderer {
 public:
  /// \pre a context of that backend is current. \returns kBackendFailed naming the function that is missing.
  [[nodiscard]] static Rendered<std::unique_ptr<GlRenderer>> load(const GlLoader& loader);
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// "llvmpipe (LLVM 15.0.6, 128 bits), 4.5 (Compatibility Profile) Mesa 22.3.6".
  [[nodiscard]] std::string description() const;
  /// \pre the context is current. Errors as OffscreenContext::draw().
  [[nodiscard]] Rendered<Image> draw(const Drawing& drawing) const;

 private:
  struct Functions;
  explicit GlRenderer(std::unique_ptr<Functions> gl);
  std::unique_ptr<Functions> gl_;
};

}  // namespace sensotwin::render
