#include "ShaderLibrary/hdrp_frame.h"

#include <bit>
#include <cstring>
#include <map>
#include <stdexcept>

#include "gpu/compute_pass.h"
#include "gpu/resources.h"
#include "shaders/reflect.h"

namespace penumbra::shader_library_tests {
namespace {

const std::string kSource = PENUMBRA_SOURCE_DIR;

constexpr const char* kIncludes =
    "#include \"Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl\"\n"
    "#include \"Packages/com.unity.render-pipelines.high-definition/Runtime/ShaderLibrary/"
    "ShaderVariables.hlsl\"\n"
    "#include \"Packages/com.penumbra.shadows/ShaderLibrary/Pipelines/Hdrp.hlsl\"\n";

struct Compiled {
  explicit Compiled(std::vector<std::uint32_t> module)
      : reflection(shaders::reflect(module)), pass(device(), {.spirv = std::move(module)}) {}
  shaders::Reflection reflection;
  gpu::ComputePass pass;
};

// A function is run on many frames; compiling takes longer than running.
Compiled& program_of(const HdrpFunction& function, HdrpVersion version, DepthDirection direction) {
  device();  // outlives the passes
  static std::map<std::pair<std::string, HdrpDefines>, Compiled> passes;
  shaders::CompileRequest request;
  request.file = "hdrp test.hlsl";
  request.text = kernel_text(kIncludes, function.statement, function.inputs, function.outputs);
  request.defines = defines_of(version);
  request.defines.insert(request.defines.end(), function.defines.begin(), function.defines.end());
  if (direction == DepthDirection::reversed) request.defines.emplace_back("UNITY_REVERSED_Z", "1");
  request.package_roots = hdrp_package_roots();
  const auto found = passes.find({*request.text, request.defines});
  if (found != passes.end()) return found->second;
  return passes.emplace(std::pair(*request.text, request.defines), compiled(request)).first->second;
}

// The words of a structured buffer, which Direct3D packs.
class Words {
 public:
  Words& add(float value) {
    words_.push_back(value);
    return *this;
  }
  Words& add(std::int32_t value) { return add(std::bit_cast<float>(value)); }
  Words& add(const glm::vec2& value) { return add(value.x).add(value.y); }
  Words& add(const glm::vec3& value) { return add(value.x).add(value.y).add(value.z); }
  Words& add(const glm::vec4& value) { return add(value.x).add(value.y).add(value.z).add(value.w); }
  Words& align() {
    words_.resize((words_.size() + 3) / 4 * 4, 0.0f);
    return *this;
  }
  const std::vector<float>& get() const { return words_; }

 private:
  std::vector<float> words_;
};

Words shadow_words(const HdrpFrame& frame, HdrpVersion version) {
  Words words;
  for (const HdrpShadow& shadow : frame.shadows) {
    words.align();
    for (const glm::vec4& row : shadow.view) words.add(glm::vec3(row));
    words.add(glm::vec3(shadow.view[0].w, shadow.view[1].w, shadow.view[2].w)).add(shadow.projection);
    words.add(shadow.atlas_offset).add(shadow.world_texel_size).add(shadow.normal_bias);
    words.add(glm::vec4(0.0f)).add(glm::vec4(shadow.tile_texels, 1.0f / shadow.tile_texels));
    words.align().add(0.0f).add(shadow.blocker_samples).add(shadow.filter_samples).add(0.0f);
    if (version != HdrpVersion::v14) words.add(shadow.params0).add(shadow.params1);
    words.add(shadow.cache_translation).add(0.0f);
    for (int row = 0; row < 4; ++row) words.add(glm::vec4(0.0f));
  }
  return words;
}

Words directional_words(const HdrpFrame& frame, HdrpVersion version) {
  const std::size_t length = version == HdrpVersion::six_cascades ? 6 : 4;
  Words words;
  for (std::size_t i = 0; i < length; ++i) {
    words.add(i < frame.spheres.size() ? frame.spheres[i] : glm::vec4(0.0f));
  }
  words.add(glm::vec4(0.0f, 0.0f, 0.0f, static_cast<float>(frame.spheres.size())));
  for (std::size_t i = 0; i < length; ++i) words.add(i < frame.borders.size() ? frame.borders[i] : 0.0f);
  return words.add(0.0f).add(0.0f).align();
}

Words sun_words(const HdrpFrame& frame) {
  Words words;
  return words.add(frame.forward).add(frame.first_shadow).add(frame.dimmer).align();
}

std::vector<std::byte> loose_uniforms(const shaders::Resource& block, const HdrpFrame& frame) {
  const glm::vec2 size = frame.atlas_texels;
  const std::map<std::string, std::vector<float>> values{
      {"_CascadeShadowAtlasSize", {size.x, size.y, 1.0f / size.x, 1.0f / size.y}},
      {"_CascadeShadowCount", {std::bit_cast<float>(static_cast<std::uint32_t>(frame.spheres.size()))}},
      {"_DirectionalShadowIndex", {std::bit_cast<float>(frame.shadow_index)}},
      {"_PenumbraMainLightParams", Words().add(frame.main_light_params).get()},
      {"_PenumbraPcssHdrpParameters0", Words().add(frame.pcss[0]).get()},
      {"_PenumbraPcssHdrpParameters1", Words().add(frame.pcss[1]).get()}};
  std::vector<std::byte> bytes(block.size);
  for (const shaders::UniformMember& member : block.members) {
    const auto value = values.find(member.name);
    if (value == values.end()) continue;
    std::memcpy(bytes.data() + member.offset, value->second.data(), member.size);
  }
  return bytes;
}

// Binds every resource that the module uses, by its name in the shader.
void bind(Compiled& program, const HdrpFrame& frame, const std::map<std::string, gpu::Buffer>& buffers,
          DepthDirection direction) {
  const auto compare = direction == DepthDirection::reversed ? gpu::SamplerKind::compare_greater_equal
                                                             : gpu::SamplerKind::compare_less_equal;
  gpu::Bindings& bindings = program.pass.bindings();
  for (const shaders::Resource& resource : program.reflection.resources) {
    if (resource.kind == shaders::ResourceKind::uniform_block) {
      bindings.uniform_bytes(resource.name, loose_uniforms(resource, frame));
    } else if (resource.kind == shaders::ResourceKind::sampled_image) {
      gpu::Image atlas(device(), gpu::Format::depth32, static_cast<int>(frame.atlas_texels.x),
                       static_cast<int>(frame.atlas_texels.y));
      atlas.upload(frame.atlas);
      bindings.image(resource.name, atlas);
    } else if (resource.kind == shaders::ResourceKind::sampler) {
      const bool compares = resource.name == "sampler_PenumbraLinearClampCompare";
      bindings.sampler(resource.name,
                       gpu::Sampler(device(), compares ? compare : gpu::SamplerKind::point_clamp));
    } else {
      bindings.buffer(resource.name, buffers.at(resource.name));
    }
  }
}

gpu::Buffer uploaded(const std::vector<float>& words) {
  return gpu::Buffer(device(), std::span<const float>(words));
}

}  // namespace

HdrpDefines defines_of(HdrpVersion version) {
  switch (version) {
    case HdrpVersion::v14:
      return {{"UNITY_VERSION", "202230"}};
    case HdrpVersion::v17:
      return {{"UNITY_VERSION", "60000000"}, {"STAND_IN_HDRP_17", "1"}};
    case HdrpVersion::six_cascades:
      return {{"STAND_IN_HDRP_SIX_CASCADES", "1"}};
  }
  return {};
}

std::vector<project::PackageRoot> hdrp_package_roots() {
  const std::string stand_ins = kSource + "/tools/programs/shaders/unity/";
  return {{"com.penumbra.shadows", kSource},
          {"com.unity.render-pipelines.core", stand_ins + "com.unity.render-pipelines.core"},
          {"com.unity.render-pipelines.high-definition",
           stand_ins + "com.unity.render-pipelines.high-definition"}};
}

std::vector<float> run(const HdrpFunction& function, HdrpVersion version, DepthDirection direction,
                       const HdrpFrame& frame, const std::vector<float>& inputs) {
  Compiled& program = program_of(function, version, direction);
  const std::size_t cases = inputs.size() / std::size_t(function.inputs);
  const std::size_t groups = (cases + kGroupSize - 1) / kGroupSize;
  std::vector<float> padded = inputs;
  padded.resize(groups * kGroupSize * std::size_t(function.inputs), 0.0f);

  const gpu::Buffer outputs(device(), groups * kGroupSize * std::size_t(function.outputs) * sizeof(float));
  bind(program, frame,
       {{"inputs", uploaded(padded)},
        {"outputs", outputs},
        {"_HDShadowDatas", uploaded(shadow_words(frame, version).get())},
        {"_HDDirectionalShadowData", uploaded(directional_words(frame, version).get())},
        {"_DirectionalLightDatas", uploaded(sun_words(frame).get())}},
       direction);
  program.pass.dispatch({static_cast<std::uint32_t>(groups), 1, 1});
  for (const std::string& message : device().validation_log()->messages()) throw std::runtime_error(message);

  std::vector<float> results = outputs.download<float>();
  results.resize(cases * std::size_t(function.outputs));
  return results;
}

}  // namespace penumbra::shader_library_tests
