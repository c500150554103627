// Runs one pass of the package's .shader over images made by hand.
#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "resolve/camera_image.h"
#include "resolve/program_on_device.h"
#include "resolve/test_device.h"
#include "resolve/texel_counter.h"
#include "shaders/counted_module.h"

namespace penumbra::resolve {

struct HandImage {
  int width = 0;
  int height = 0;
  std::vector<float> texels;

  float at(int x, int y) const { return texels.at(static_cast<std::size_t>(y * width + x)); }
  float& at(int x, int y) { return texels.at(static_cast<std::size_t>(y * width + x)); }
  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
};

inline HandImage filled(int width, int height, float value) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(width * height), value)};
}

inline glm::vec4 size_vector(int width, int height) {
  return {float(width), float(height), 1.0f / float(width), 1.0f / float(height)};
}

// A camera at the origin that looks along +z, with 90 degrees both ways, near 0.1 m, far 1 km, and reversed
// depth.
struct HandCamera {
  static constexpr double kNear = 0.1;
  static constexpr double kFar = 1000.0;
  static float stored(double z) {
    return static_cast<float>(kNear * kFar / (kFar - kNear) / z - kNear / (kFar - kNear));
  }
  static glm::dmat4 screen_to_world() {
    const double scale = kNear * kFar / (kFar - kNear);
    const double offset = -kNear / (kFar - kNear);
    glm::dmat4 matrix(0.0);
    matrix[0] = {2.0, 0.0, 0.0, 0.0};
    matrix[1] = {0.0, -2.0, 0.0, 0.0};
    matrix[2] = {0.0, 0.0, 0.0, 1.0 / scale};
    matrix[3] = {-1.0, 1.0, 1.0, -offset / scale};
    return matrix;
  }
  // The view depth where the ray through a pixel meets the plane through (0, 0, distance) with this normal.
  static double on_plane(const glm::dvec3& normal, double distance, int x, int y, int width, int height) {
    const glm::dvec3 ray((x + 0.5) / width * 2.0 - 1.0, 1.0 - (y + 0.5) / height * 2.0, 1.0);
    return normal.z * distance / glm::dot(normal, ray);
  }
};

struct PassAnswer {
  HandImage image;
  std::vector<int> fetches;
  std::vector<int> written;
};

// Runs a pass with a depth image and a source, in two rounds: as it ships, and counting.
class PassRunner {
 public:
  explicit PassRunner(const std::string& pass,
                      const std::filesystem::path& shader = shaders::package_shader_file(),
                      bool reversed_z = true)
      : compiled_(compile_pass(shaders::PackageShader(shader), pass, {}, reversed_z)),
        plain_(test_device(), compiled_, ProgramOnDevice::Module::as_shipped, kTarget),
        counting_(test_device(), compiled_, ProgramOnDevice::Module::counting, kTarget) {}

  PassAnswer run(const HandImage& depth, const HandImage& source, int width, int height,
                 const UniformValues& more = {}) {
    UniformValues values;
    const std::array<glm::dmat4, 2> eyes{HandCamera::screen_to_world(), HandCamera::screen_to_world()};
    values.set("_PenumbraScreenToWorld", std::span<const glm::dmat4>(eyes));
    values.set("_PenumbraScreenSize", size_vector(depth.width, depth.height));
    values.set("_PenumbraTargetSize", size_vector(width, height));
    values.set("_PenumbraSourceSize", size_vector(source.width, source.height));
    values.set("_PenumbraMaskSize", glm::vec4(0.0f));
    values.merge(more);
    const gpu::Image depth_image = uploaded(depth);
    const gpu::Image source_image = uploaded(source);
    NamedResources resources;
    // No cascade covers anything, so nothing reads it.
    const gpu::Image shadow_map(test_device(), gpu::Format::depth32, 1, 1);
    resources.images = {{"_CameraDepthTexture", {&depth_image}},
                        {"_PenumbraSourceTexture", {&source_image}},
                        // The mask counts as absent, because _PenumbraMaskSize is 0.
                        {"_PenumbraMaskTexture", {&source_image}},
                        {"_MainLightShadowmapTexture", {&shadow_map}}};
    const gpu::Sampler compare(test_device(), gpu::SamplerKind::compare_greater_equal);
    resources.samplers = {{"sampler_PenumbraLinearClampCompare", &compare}};
    const gpu::Image plain(test_device(), gpu::Format::r32f, width, height);
    const gpu::Image counted(test_device(), gpu::Format::r32f, width, height);
    draw(plain_, plain, resources, values);
    const TexelCounter counter(test_device(), width, height);
    resources.buffers = {{shaders::texel_counts_name, &counter.buffer()}};
    draw(counting_, counted, resources, values);
    const TexelCounts counts = counter.counts();
    return {{width, height, plain.download<float>()},
            {counts.fetches.begin(), counts.fetches.end()},
            {counts.written.begin(), counts.written.end()}};
  }

 private:
  static gpu::Image uploaded(const HandImage& image) {
    gpu::Image made(test_device(), gpu::Format::r32f, image.width, image.height);
    made.upload(image.texels);
    return made;
  }

  static void draw(const ProgramOnDevice& program, const gpu::Image& target, const NamedResources& resources,
                   const UniformValues& values) {
    gpu::Sequence sequence(test_device());
    gpu::Bindings bindings = program.bind(resources);
    program.set_uniforms(bindings, values);
    program.draw(sequence, bindings, {{&target}, nullptr, 0.0F}, whole_of(target));
    sequence.run();
  }

  static inline const TargetFormats kTarget{.colours = {gpu::Format::r32f}};
  CompiledProgram compiled_;
  ProgramOnDevice plain_;
  ProgramOnDevice counting_;
};

}  // namespace penumbra::resolve
