#include "resolve/debug_view.h"

#include <algorithm>
#include <utility>

#include "platform/hashed_fields.h"

namespace penumbra::resolve {
namespace {

constexpr int kMaskBlock = 4;  // pixels of the screen per texel of the mask, each way

// Builds the mask's texture again from its values for each pixel.
gpu::Image mask_texture(const gpu::Device& device, const CameraImage& camera,
                        const std::vector<std::uint8_t>& masked_out) {
  const int width = (camera.width + kMaskBlock - 1) / kMaskBlock;
  const int height = (camera.height + kMaskBlock - 1) / kMaskBlock;
  const std::vector<std::uint8_t> pixels = rows_from_top(masked_out, camera.width, camera.rows);
  std::vector<float> texels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(kMaskBlock) *
                                (static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) +
                                 static_cast<std::size_t>(x));
      texels.push_back(pixels.empty() || pixels[pixel] == 0 ? 1.0f : 0.0f);
    }
  }
  gpu::Image image(device, gpu::Format::r32f, width, height);
  image.upload(texels);
  return image;
}

}  // namespace

DebugView::DebugView(const gpu::Device& device, const shaders::PackageShader& shader, const std::string& view,
                     bool reversed_z, const Compiler& compiler)
    : DebugView(device, compile_pass(shader, view, {}, reversed_z, compiler)) {}

DebugView::DebugView(const gpu::Device& device, CompiledProgram program)
    : device_(device),
      key_(platform::hash_of(program)),
      program_(device, std::move(program), ProgramOnDevice::Module::as_shipped,
               {.colours = {gpu::Format::rgba32f}}) {}

std::vector<glm::vec3> DebugView::draw(const FrameOnDevice& frame, const CameraImage& camera,
                                       const std::vector<float>& visibility,
                                       const std::vector<std::uint8_t>& masked_out,
                                       const UniformValues& parameters, std::optional<RowOrder> picture) {
  const RowOrder picture_rows = picture.value_or(camera.rows);
  gpu::Image depth(device_, gpu::Format::r32f, camera.width, camera.height);
  depth.upload(camera.depth);
  gpu::Image seen(device_, gpu::Format::r32f, camera.width, camera.height);
  seen.upload(rows_from_top(visibility, camera.width, camera.rows));
  const gpu::Image mask = mask_texture(device_, camera, masked_out);
  const gpu::Image target(device_, gpu::Format::rgba32f, camera.width, camera.height);

  UniformValues values = frame.uniforms(0);
  values.merge(parameters);
  set_screen(values, camera);
  values.set("_PenumbraTargetSize", texture_size(target));
  values.set("_PenumbraDebugParams", glm::vec4(masked_out.empty() ? 0.0f : 1.0f, 0.0f,
                                               picture_rows == camera.rows ? 0.0f : 1.0f, 0.0f));
  NamedResources resources;
  for (const auto& [name, image] : frame.images()) resources.images[name] = {image};
  resources.images["_CameraDepthTexture"] = {&depth};
  resources.images["_ScreenSpaceShadowmapTexture"] = {&seen};
  resources.images["_PenumbraMaskTexture"] = {&mask};
  resources.samplers = frame.samplers();
  gpu::Sequence sequence(device_);
  gpu::Bindings bindings = program_.bind(resources);
  program_.set_uniforms(bindings, values);
  program_.draw(sequence, bindings, {{&target}, nullptr, 0.0F}, whole_of(target));
  sequence.run();

  std::vector<glm::vec3> colours;
  for (const glm::vec4& texel : target.download<glm::vec4>()) colours.emplace_back(texel);
  return rows_from_top(colours, camera.width, picture_rows);
}

}  // namespace penumbra::resolve
