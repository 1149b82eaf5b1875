// SPDX-License-Identifier: MIT
#include <GL/gl.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <array>

#include "render/gl_renderer.hpp"
#include "render/offscreen_context.hpp"

namespace sensotwin::render {
namespace {

// The five functions of GL/osmesa.h that are used, spelt here because that header leaves Debian with
// Mesa 25.1.
using OsMesaHandle = void*;
constexpr GLenum kOsMesaRgba = GL_RGBA;

struct OsMesa {
  OsMesaHandle (*create_context_ext)(GLenum format, GLint depth_bits, GLint stencil_bits, GLint accum_bits,
                                     OsMesaHandle share){};
  void (*destroy_context)(OsMesaHandle){};
  GLboolean (*make_current)(OsMesaHandle, void* buffer, GLenum type, GLsizei width, GLsizei height){};
  GlFunction (*get_proc_address)(const char* name){};

  [[nodiscard]] bool load(void* library) {
    const auto get = [library](auto& pointer, const char* name) {
      pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(::dlsym(library, name));
      return pointer != nullptr;
    };
    return get(create_context_ext, "OSMesaCreateContextExt") &&
           get(destroy_context, "OSMesaDestroyContext") && get(make_current, "OSMesaMakeCurrent") &&
           get(get_proc_address, "OSMesaGetProcAddress");
  }
};

class OsMesaContext final : public OffscreenContext {
 public:
  OsMesaContext(const OsMesa& osmesa, OsMesaHandle handle) : osmesa_(osmesa), handle_(handle) {}
  ~OsMesaContext() override {
    gl_.reset();
    osmesa_.destroy_context(handle_);
  }
  /// \returns the reason why not, empty when ready.
  [[nodiscard]] std::string prepare() {
    if (!make_current()) {
      return "OSMesa made no context current";
    }
    auto gl = GlRenderer::load([this](const char* name) { return osmesa_.get_proc_address(name); });
    if (!gl) {
      return gl.error().message;
    }
    gl_ = std::move(*gl);
    set_renderer("OSMesa: " + gl_->description());
    return {};
  }

 private:
  Rendered<Image> do_draw(const Drawing& drawing) override {
    if (!make_current()) {
      return Unexpected{RenderError{RenderError::Kind::kBackendFailed, "OSMesa lost its context"}};
    }
    return gl_->draw(drawing);
  }
  /// OSMesa insists on a picture of its own; ours is drawn in a frame buffer object, so one small tile
  /// serves.
  [[nodiscard]] bool make_current() {
    return osmesa_.make_current(handle_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferSide, kBufferSide) ==
           GL_TRUE;
  }

  static constexpr int kBufferSide = 16;
  OsMesa osmesa_;
  OsMesaHandle handle_;
  std::array<std::uint8_t, std::size_t{4} * kBufferSide * kBufferSide> buffer_{};
  std::unique_ptr<GlRenderer> gl_;
};

}  // namespace

Rendered<std::unique_ptr<OffscreenContext>> make_osmesa_context() {
  // Never closed: Mesa keeps thread-local state that would point into a library that is gone.
  void* library = ::dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return Unexpected{
        RenderError{RenderError::Kind::kBackendMissing,
                    "OSMesa is not installed (libOSMesa.so.8; Debian: apt install libosmesa6)"}};
  }
  OsMesa osmesa;
  if (!osmesa.load(library)) {
    return Unexpected{
        RenderError{RenderError::Kind::kBackendFailed, "libOSMesa.so.8 lacks OSMesa's functions"}};
  }
  OsMesaHandle handle = osmesa.create_context_ext(kOsMesaRgba, 24, 0, 0, nullptr);
  if (handle == nullptr) {
    return Unexpected{RenderError{RenderError::Kind::kBackendFailed, "OSMesa created no context"}};
  }
  auto context = std::make_unique<OsMesaContext>(osmesa, handle);
  if (const std::string reason = context->prepare(); !reason.empty()) {
    return Unexpected{RenderError{RenderError::Kind::kBackendFailed, reason}};
  }
  return std::unique_ptr<OffscreenContext>(std::move(context));
}

}  // namespace sensotwin::render
