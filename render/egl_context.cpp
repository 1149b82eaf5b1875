// SPDX-License-Identifier: MIT
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include "render/gl_renderer.hpp"
#include "render/offscreen_context.hpp"

namespace sensotwin::render {
namespace {

struct Egl {
  decltype(&::eglBindAPI) bind_api{};
  decltype(&::eglChooseConfig) choose_config{};
  decltype(&::eglCreateContext) create_context{};
  decltype(&::eglDestroyContext) destroy_context{};
  decltype(&::eglGetError) get_error{};
  decltype(&::eglGetProcAddress) get_proc_address{};
  decltype(&::eglInitialize) initialize{};
  decltype(&::eglMakeCurrent) make_current{};
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display{};

  [[nodiscard]] bool load(void* library) {
    const auto get = [library](auto& pointer, const char* name) {
      pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(::dlsym(library, name));
      return pointer != nullptr;
    };
    if (!get(bind_api, "eglBindAPI") || !get(choose_config, "eglChooseConfig") ||
        !get(create_context, "eglCreateContext") || !get(destroy_context, "eglDestroyContext") ||
        !get(get_error, "eglGetError") || !get(get_proc_address, "eglGetProcAddress") ||
        !get(initialize, "eglInitialize") || !get(make_current, "eglMakeCurrent")) {
      return false;
    }
    get_platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc_address("eglGetPlatformDisplayEXT"));
    return get_platform_display != nullptr;
  }
};

class EglContext final : public OffscreenContext {
 public:
  EglContext(const Egl& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}
  // The display stays open: EGL hands the same one to every caller, and closing it would end their contexts
  // too.
  ~EglContext() override {
    gl_.reset();
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  /// \returns the reason why not, empty when ready.
  [[nodiscard]] std::string prepare() {
    if (!make_current()) {
      return fmt::format("EGL made no context current (error 0x{:04x})", egl_.get_error());
    }
    auto gl = GlRenderer::load([this](const char* name) { return egl_.get_proc_address(name); });
    if (!gl) {
      return gl.error().message;
    }
    gl_ = std::move(*gl);
    set_renderer("EGL surfaceless: " + gl_->description());
    return {};
  }

 private:
  Rendered<Image> do_draw(const Drawing& drawing) override {
    if (!make_current()) {
      return Unexpected{RenderError{RenderError::Kind::kBackendFailed, "EGL lost its context"}};
    }
    auto image = gl_->draw(drawing);
    // Not left current: the context may be used by another thread next, which EGL refuses while it is current
    // here.
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    return image;
  }
  [[nodiscard]] bool make_current() {
    return egl_.bind_api(EGL_OPENGL_API) == EGL_TRUE &&
           egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }

  Egl egl_;
  EGLDisplay display_;
  EGLContext context_;
  std::unique_ptr<GlRenderer> gl_;
};

[[nodiscard]] RenderError failed(const Egl& egl, const char* what) {
  return {RenderError::Kind::kBackendFailed, fmt::format("EGL: {} (error 0x{:04x})", what, egl.get_error())};
}

}  // namespace

Rendered<std::unique_ptr<OffscreenContext>> make_egl_context() {
  // Never closed, as in make_osmesa_context().
  void* library = ::dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return Unexpected{
        RenderError{RenderError::Kind::kBackendMissing,
                    "EGL is not installed (libEGL.so.1; Debian: apt install libegl1 libegl-mesa0)"}};
  }
  Egl egl;
  if (!egl.load(library)) {
    return Unexpected{
        RenderError{RenderError::Kind::kBackendFailed, "libEGL.so.1 lacks the platform display functions"}};
  }
  EGLDisplay display = egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE) {
    return Unexpected{failed(egl, "no surfaceless display; is libegl-mesa0 installed?")};
  }
  if (egl.bind_api(EGL_OPENGL_API) != EGL_TRUE) {
    return Unexpected{failed(egl, "the display knows no desktop OpenGL")};
  }
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (egl.choose_config(display, wanted, &config, 1, &count) != EGL_TRUE || count < 1) {
    return Unexpected{failed(egl, "no configuration for desktop OpenGL")};
  }
  EGLContext handle = egl.create_context(display, config, EGL_NO_CONTEXT, nullptr);
  if (handle == EGL_NO_CONTEXT) {
    return Unexpected{failed(egl, "no context")};
  }
  auto context = std::make_unique<EglContext>(egl, display, handle);
  if (const std::string reason = context->prepare(); !reason.empty()) {
    return Unexpected{RenderError{RenderError::Kind::kBackendFailed, reason}};
  }
  return std::unique_ptr<OffscreenContext>(std::move(context));
}

}  // namespace sensotwin::render
