// SPDX-License-Identifier: MIT
#include "render/gl_renderer.hpp"

// For the types and numbers: no function of libGL is linked.
#define GL_GLEXT_PROTOTYPES 1  // NOLINT(bugprone-reserved-identifier): the header's own switch
#include <GL/gl.h>
#include <GL/glext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace sensotwin::render {
namespace {

// 2x2 pixels behind each pixel, 4 samples in each of them: 16 levels of an edge. Chosen because 4 levels
// leave visible steps on nearly level lines.
constexpr int kSupersampling = 2;
constexpr int kSamples = 4;
// Picture rows drawn at a time. Chosen: the samples of a 1600 pixels wide strip then take 26 MB instead of
// 246 MB.
constexpr int kStripRows = 128;

[[nodiscard]] RenderError failed(std::string message) {
  return {RenderError::Kind::kBackendFailed, std::move(message)};
}

/// Mean of each block of kSupersampling^2 pixels. GL's rows go upwards, ours downwards.
void reduce_strip(std::span<const std::uint8_t> samples, int strip_rows, int first_row, Image& image) {
  constexpr std::size_t kSide = kSupersampling;
  const std::size_t wide = static_cast<std::size_t>(image.width_px()) * kSide;
  for (int y = 0; y < strip_rows; ++y) {
    for (int x = 0; x < image.width_px(); ++x) {
      std::array<int, 3> sum{};
      for (int sy = 0; sy < kSupersampling; ++sy) {
        const std::size_t gl_row =
            static_cast<std::size_t>(strip_rows - 1 - y) * kSide + static_cast<std::size_t>(sy);
        const std::uint8_t* p = &samples[(gl_row * wide + static_cast<std::size_t>(x) * kSide) * 4u];
        for (int sx = 0; sx < kSupersampling; ++sx, p += 4) {
          sum[0] += p[0];
          sum[1] += p[1];
          sum[2] += p[2];
        }
      }
      constexpr int kCount = kSupersampling * kSupersampling;
      const auto mean = [](int s) { return static_cast<std::uint8_t>((s + kCount / 2) / kCount); };
      image.at(x, first_row + y) = {mean(sum[0]), mean(sum[1]), mean(sum[2]), 255};
    }
  }
}

/// Sorts triangles by the strips that they touch. A long path has 10^6 triangles, and each of a dozen strips
/// would have them all transformed again.
class Strips {
 public:
  explicit Strips(const Drawing& drawing) : drawing_(drawing) {
    const Eigen::Matrix4f clip_from_W = drawing.clip_from_W.cast<float>();
    const auto height = static_cast<float>(drawing.height_px);
    for (const TriangleLayer& layer : drawing.layers) {
      std::vector<Rows>& rows = rows_.emplace_back();
      rows.reserve(layer.vertices.size() / 3);
      for (std::size_t i = 0; i + 2 < layer.vertices.size(); i += 3) {
        Rows range{height, 0.0F};
        for (std::size_t k = i; k < i + 3; ++k) {
          const Vertex& v = layer.vertices[k];
          const Eigen::Vector4f clip = clip_from_W * Eigen::Vector4f{v.x, v.y, v.z, 1.0F};
          // Behind the eye there is no row: the driver clips, so the triangle goes into all strips.
          const bool ahead = clip.w() > 0.0F;
          const float row = ahead ? (1.0F - clip.y() / clip.w()) * height / 2.0F : 0.0F;
          range.first = std::min(range.first, ahead ? row : 0.0F);
          range.last = std::max(range.last, ahead ? row : height);
        }
        rows.push_back(range);
      }
    }
  }

  /// The drawing's layers with the triangles that touch picture rows [first, end), in their order.
  [[nodiscard]] std::vector<TriangleLayer> layers(int first, int end) const {
    // A row beyond either side, against rounding.
    const auto low = static_cast<float>(first - 1);
    const auto high = static_cast<float>(end + 1);
    std::vector<TriangleLayer> chosen;
    for (std::size_t l = 0; l < rows_.size(); ++l) {
      const TriangleLayer& all = drawing_.layers[l];
      TriangleLayer& some = chosen.emplace_back();
      some.depth_test = all.depth_test;
      some.depth_write = all.depth_write;
      for (std::size_t t = 0; t < rows_[l].size(); ++t) {
        if (rows_[l][t].first <= high && rows_[l][t].last >= low) {
          const auto begin = all.vertices.begin() + static_cast<std::ptrdiff_t>(3 * t);
          some.vertices.insert(some.vertices.end(), begin, begin + 3);
        }
      }
    }
    return chosen;
  }

 private:
  struct Rows {
    float first{0.0F};
    float last{0.0F};
  };
  const Drawing& drawing_;
  std::vector<std::vector<Rows>> rows_;
};

}  // namespace

struct GlRenderer::Functions {
  decltype(&::glBindFramebuffer) bind_framebuffer{};
  decltype(&::glBindRenderbuffer) bind_renderbuffer{};
  decltype(&::glBlendFunc) blend_func{};
  decltype(&::glBlitFramebuffer) blit_framebuffer{};
  decltype(&::glCheckFramebufferStatus) check_framebuffer{};
  decltype(&::glClear) clear{};
  decltype(&::glClearColor) clear_color{};
  decltype(&::glColorPointer) color_pointer{};
  decltype(&::glDeleteFramebuffers) delete_framebuffers{};
  decltype(&::glDeleteRenderbuffers) delete_renderbuffers{};
  decltype(&::glDepthFunc) depth_func{};
  decltype(&::glDepthMask) depth_mask{};
  decltype(&::glDisable) disable{};
  decltype(&::glDrawArrays) draw_arrays{};
  decltype(&::glEnable) enable{};
  decltype(&::glEnableClientState) enable_client_state{};
  decltype(&::glFramebufferRenderbuffer) framebuffer_renderbuffer{};
  decltype(&::glGenFramebuffers) gen_framebuffers{};
  decltype(&::glGenRenderbuffers) gen_renderbuffers{};
  decltype(&::glGetError) get_error{};
  decltype(&::glGetIntegerv) get_integer{};
  decltype(&::glGetString) get_string{};
  decltype(&::glLoadMatrixd) load_matrix{};
  decltype(&::glMatrixMode) matrix_mode{};
  decltype(&::glReadPixels) read_pixels{};
  decltype(&::glRenderbufferStorageMultisample) storage_multisample{};
  decltype(&::glVertexPointer) vertex_pointer{};
  decltype(&::glViewport) viewport{};
  int samples{0};

  /// \returns the name of the first function that the driver lacks, or null.
  const char* load(const GlLoader& loader);
  /// \param layers  of the drawing, with the triangles that matter
  void draw_layers(const Drawing& drawing, std::span<const TriangleLayer> layers) const;
};

/// A frame buffer with one colour buffer, and a depth buffer when multisampled; freed at the end of the
/// scope.
class GlTarget {
 public:
  template <class Functions>
  GlTarget(const Functions& gl, int width, int height, int samples, bool with_depth)
      : delete_framebuffers_(gl.delete_framebuffers), delete_renderbuffers_(gl.delete_renderbuffers) {
    gl.gen_framebuffers(1, &frame_);
    gl.gen_renderbuffers(2, buffers_.data());
    gl.bind_framebuffer(GL_FRAMEBUFFER, frame_);
    gl.bind_renderbuffer(GL_RENDERBUFFER, buffers_[0]);
    gl.storage_multisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
    gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers_[0]);
    if (with_depth) {
      gl.bind_renderbuffer(GL_RENDERBUFFER, buffers_[1]);
      gl.storage_multisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
      gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers_[1]);
    }
    complete_ = gl.check_framebuffer(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  ~GlTarget() {
    delete_framebuffers_(1, &frame_);
    delete_renderbuffers_(2, buffers_.data());
  }
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;
  [[nodiscard]] GLuint frame() const { return frame_; }
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  decltype(&::glDeleteFramebuffers) delete_framebuffers_;
  decltype(&::glDeleteRenderbuffers) delete_renderbuffers_;
  GLuint frame_{0};
  std::array<GLuint, 2> buffers_{};
  bool complete_{false};
};

const char* GlRenderer::Functions::load(const GlLoader& loader) {
  const char* missing = nullptr;
  const auto get = [&](auto& pointer, const char* name) {
    pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(loader(name));
    if (pointer == nullptr && missing == nullptr) {
      missing = name;
    }
  };
  get(bind_framebuffer, "glBindFramebuffer");
  get(bind_renderbuffer, "glBindRenderbuffer");
  get(blend_func, "glBlendFunc");
  get(blit_framebuffer, "glBlitFramebuffer");
  get(check_framebuffer, "glCheckFramebufferStatus");
  get(clear, "glClear");
  get(clear_color, "glClearColor");
  get(color_pointer, "glColorPointer");
  get(delete_framebuffers, "glDeleteFramebuffers");
  get(delete_renderbuffers, "glDeleteRenderbuffers");
  get(depth_func, "glDepthFunc");
  get(depth_mask, "glDepthMask");
  get(disable, "glDisable");
  get(draw_arrays, "glDrawArrays");
  get(enable, "glEnable");
  get(enable_client_state, "glEnableClientState");
  get(framebuffer_renderbuffer, "glFramebufferRenderbuffer");
  get(gen_framebuffers, "glGenFramebuffers");
  get(gen_renderbuffers, "glGenRenderbuffers");
  get(get_error, "glGetError");
  get(get_integer, "glGetIntegerv");
  get(get_string, "glGetString");
  get(load_matrix, "glLoadMatrixd");
  get(matrix_mode, "glMatrixMode");
  get(read_pixels, "glReadPixels");
  get(storage_multisample, "glRenderbufferStorageMultisample");
  get(vertex_pointer, "glVertexPointer");
  get(viewport, "glViewport");
  return missing;
}

void GlRenderer::Functions::draw_layers(const Drawing& drawing, std::span<const TriangleLayer> layers) const {
  const auto channel = [](std::uint8_t v) { return static_cast<float>(v) / 255.0F; };
  const Rgba& paper = drawing.background;
  depth_mask(GL_TRUE);
  clear_color(channel(paper.r), channel(paper.g), channel(paper.b), 1.0F);
  clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  matrix_mode(GL_MODELVIEW);
  load_matrix(Eigen::Matrix4d::Identity().eval().data());
  matrix_mode(GL_PROJECTION);
  load_matrix(drawing.clip_from_W.data());
  enable(GL_BLEND);
  blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  depth_func(GL_LEQUAL);
  enable_client_state(GL_VERTEX_ARRAY);
  enable_client_state(GL_COLOR_ARRAY);
  for (const TriangleLayer& layer : layers) {
    if (layer.vertices.empty()) {
      continue;
    }
    layer.depth_test ? enable(GL_DEPTH_TEST) : disable(GL_DEPTH_TEST);
    depth_mask(layer.depth_write ? GL_TRUE : GL_FALSE);
    vertex_pointer(3, GL_FLOAT, sizeof(Vertex), &layer.vertices[0].x);
    color_pointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), &layer.vertices[0].color);
    draw_arrays(GL_TRIANGLES, 0, static_cast<GLsizei>(layer.vertices.size()));
  }
}

GlRenderer::GlRenderer(std::unique_ptr<Functions> gl) : gl_(std::move(gl)) {}
GlRenderer::~GlRenderer() = default;

Rendered<std::unique_ptr<GlRenderer>> GlRenderer::load(const GlLoader& loader) {
  auto gl = std::make_unique<Functions>();
  if (const char* missing = gl->load(loader)) {
    return Unexpected{failed(fmt::format("this OpenGL driver has no {}", missing))};
  }
  GLint most = 0;
  gl->get_integer(GL_MAX_SAMPLES, &most);
  gl->samples = most >= kSamples ? kSamples : 0;
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(gl)));
}

std::string GlRenderer::description() const {
  const auto text = [this](GLenum what) {
    const auto* s = reinterpret_cast<const char*>(gl_->get_string(what));
    return std::string(s == nullptr ? "unknown" : s);
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

Rendered<Image> GlRenderer::draw(const Drawing& drawing) const {
  if (drawing.width_px < 1 || drawing.height_px < 1 || drawing.width_px > kLargestSide_px ||
      drawing.height_px > kLargestSide_px) {
    return Unexpected{RenderError{RenderError::Kind::kBadView,
                                  fmt::format("cannot draw {} x {} pixels: each side must be 1 to {}",
                                              drawing.width_px, drawing.height_px, kLargestSide_px)}};
  }
  const int width = drawing.width_px * kSupersampling;
  const int strip_height = std::min(kStripRows, drawing.height_px) * kSupersampling;
  const GlTarget many(*gl_, width, strip_height, gl_->samples, true);
  const GlTarget one(*gl_, width, strip_height, 0, false);
  if (!many.complete() || !one.complete()) {
    return Unexpected{
        failed(fmt::format("OpenGL gave no frame buffer of {} x {} pixels", width, strip_height))};
  }
  Image image(drawing.width_px, drawing.height_px, drawing.background);
  std::vector<std::uint8_t> samples(static_cast<std::size_t>(width) * static_cast<std::size_t>(strip_height) *
                                    4u);
  const Strips strips(drawing);
  for (int row = 0; row < drawing.height_px; row += kStripRows) {
    const int rows = std::min(kStripRows, drawing.height_px - row);
    gl_->bind_framebuffer(GL_FRAMEBUFFER, many.frame());
    // The strip is a window on the whole picture: GL counts rows from below.
    const int below = (drawing.height_px - row - rows) * kSupersampling;
    gl_->viewport(0, -below, width, drawing.height_px * kSupersampling);
    gl_->draw_layers(drawing, strips.layers(row, row + rows));
    gl_->bind_framebuffer(GL_READ_FRAMEBUFFER, many.frame());
    gl_->bind_framebuffer(GL_DRAW_FRAMEBUFFER, one.frame());
    gl_->blit_framebuffer(0, 0, width, strip_height, 0, 0, width, strip_height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
    gl_->bind_framebuffer(GL_READ_FRAMEBUFFER, one.frame());
    gl_->read_pixels(0, 0, width, rows * kSupersampling, GL_RGBA, GL_UNSIGNED_BYTE, samples.data());
    reduce_strip(samples, rows, row, image);
  }
  gl_->bind_framebuffer(GL_FRAMEBUFFER, 0);
  if (const GLenum error = gl_->get_error(); error != GL_NO_ERROR) {
    return Unexpected{failed(fmt::format("OpenGL error 0x{:04x} while drawing", error))};
  }
  return image;
}

}  // namespace sensotwin::render
