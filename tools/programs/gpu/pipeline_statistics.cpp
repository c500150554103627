#include "gpu/pipeline_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "gpu/instance.h"
#include "shaders/pipeline_interface.h"

namespace penumbra::gpu {

struct StatisticsDevice::State {
  explicit State(vk::raii::Context loaded) : context(std::move(loaded)) {}

  DeviceInfo info;
  vk::raii::Context context;
  vk::raii::Instance instance = nullptr;
  vk::raii::Device device = nullptr;
};

namespace {

using shaders::PipelineInterface;
using shaders::StageLocation;

constexpr const char* statistics_extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;

// The device has every feature, so that any shader compiles; but robust access is off, because it would make
// all buffer reads dearer than they are in a game.
vk::raii::Device open_device(const Candidate& candidate) {
  const vk::raii::PhysicalDevice& physical = candidate.physical;
  const std::vector<vk::ExtensionProperties> offered = physical.enumerateDeviceExtensionProperties();
  if (!offers(offered, statistics_extension))
    throw EnvironmentError(candidate.info.name + " (" + candidate.info.driver + "): no " +
                           statistics_extension + " here");
  std::vector<const char*> extensions{statistics_extension};
  auto features =
      physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDevice16BitStorageFeatures,
                            vk::PhysicalDeviceMultiviewFeatures, vk::PhysicalDeviceShaderFloat16Int8Features,
                            vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
  if (offers(offered, VK_KHR_SHADER_FLOAT16_INT8_EXTENSION_NAME)) {
    extensions.push_back(VK_KHR_SHADER_FLOAT16_INT8_EXTENSION_NAME);
  } else {
    features.unlink<vk::PhysicalDeviceShaderFloat16Int8Features>();
  }
  features.get<vk::PhysicalDeviceFeatures2>().features.robustBufferAccess = VK_FALSE;
  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, candidate.queue_family, 1, &priority);
  vk::DeviceCreateInfo create({}, queue, {}, extensions);
  create.pNext = &features.get<vk::PhysicalDeviceFeatures2>();
  return {physical, create};
}

vk::DescriptorType descriptor_type(shaders::DescriptorKind kind) {
  using shaders::DescriptorKind;
  switch (kind) {
    case DescriptorKind::uniform_buffer:
      return vk::DescriptorType::eUniformBuffer;
    case DescriptorKind::storage_buffer:
      return vk::DescriptorType::eStorageBuffer;
    case DescriptorKind::sampled_image:
      return vk::DescriptorType::eSampledImage;
    case DescriptorKind::storage_image:
      return vk::DescriptorType::eStorageImage;
    case DescriptorKind::uniform_texel_buffer:
      return vk::DescriptorType::eUniformTexelBuffer;
    case DescriptorKind::storage_texel_buffer:
      return vk::DescriptorType::eStorageTexelBuffer;
    case DescriptorKind::combined_image_sampler:
      return vk::DescriptorType::eCombinedImageSampler;
    case DescriptorKind::sampler:
      return vk::DescriptorType::eSampler;
    case DescriptorKind::input_attachment:
      break;
  }
  return vk::DescriptorType::eInputAttachment;
}

struct Layout {
  std::vector<vk::raii::DescriptorSetLayout> sets;
  vk::raii::PipelineLayout pipeline = nullptr;
};

// All stages see all of the layout; where two name the same binding, the larger array counts.
Layout make_layout(const vk::raii::Device& device, const std::vector<const PipelineInterface*>& interfaces,
                   vk::ShaderStageFlags stages) {
  std::map<std::uint32_t, std::map<std::uint32_t, vk::DescriptorSetLayoutBinding>> by_set;
  std::uint32_t push_constants = 0;
  for (const PipelineInterface* interface : interfaces) {
    push_constants = std::max(push_constants, interface->push_constant_bytes);
    for (const shaders::Descriptor& wanted : interface->descriptors) {
      vk::DescriptorSetLayoutBinding& binding = by_set[wanted.set][wanted.binding];
      const std::uint32_t count = std::max(binding.descriptorCount, wanted.count);
      binding = {wanted.binding, descriptor_type(wanted.kind), count, stages};
    }
  }
  Layout layout;
  std::vector<vk::DescriptorSetLayout> handles;
  const std::uint32_t set_count = by_set.empty() ? 0 : by_set.rbegin()->first + 1;
  for (std::uint32_t set = 0; set < set_count; ++set) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (const auto& [at, binding] : by_set[set]) bindings.push_back(binding);
    layout.sets.emplace_back(device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    handles.push_back(*layout.sets.back());
  }
  const vk::PushConstantRange range(stages, 0, push_constants);
  vk::PipelineLayoutCreateInfo create({}, handles);
  if (push_constants > 0) create.setPushConstantRanges(range);
  layout.pipeline = vk::raii::PipelineLayout(device, create);
  return layout;
}

vk::Format attribute_format(const StageLocation& at) {
  using shaders::ScalarType;
  static constexpr std::array floats{vk::Format::eR32Sfloat, vk::Format::eR32G32Sfloat,
                                     vk::Format::eR32G32B32Sfloat, vk::Format::eR32G32B32A32Sfloat};
  static constexpr std::array ints{vk::Format::eR32Sint, vk::Format::eR32G32Sint, vk::Format::eR32G32B32Sint,
                                   vk::Format::eR32G32B32A32Sint};
  static constexpr std::array uints{vk::Format::eR32Uint, vk::Format::eR32G32Uint, vk::Format::eR32G32B32Uint,
                                    vk::Format::eR32G32B32A32Uint};
  const std::uint32_t components = std::clamp(at.component + at.components, 1U, 4U);
  const auto& formats = at.type == ScalarType::float32 ? floats : at.type == ScalarType::int32 ? ints : uints;
  return formats[components - 1];
}

vk::Format colour_format(const StageLocation& at) {
  if (at.type == shaders::ScalarType::int32) return vk::Format::eR32G32B32A32Sint;
  if (at.type == shaders::ScalarType::uint32) return vk::Format::eR32G32B32A32Uint;
  return vk::Format::eR16G16B16A16Sfloat;
}

// The pass has colours at the locations that the fragment shader writes, and a depth buffer.
vk::raii::RenderPass make_render_pass(const vk::raii::Device& device,
                                      const std::vector<StageLocation>& outputs) {
  std::vector<vk::AttachmentDescription> attachments;
  std::vector<vk::AttachmentReference> colours;
  const auto attach = [&attachments](vk::Format format, vk::ImageLayout layout) {
    vk::AttachmentDescription description;
    description.format = format;
    description.finalLayout = layout;
    attachments.push_back(description);
    return vk::AttachmentReference(static_cast<std::uint32_t>(attachments.size() - 1), layout);
  };
  for (const StageLocation& output : outputs) {
    if (output.location >= 8) throw std::invalid_argument("a fragment shader writes more than 8 colours");
    if (colours.size() <= output.location)
      colours.resize(output.location + 1, {VK_ATTACHMENT_UNUSED, vk::ImageLayout::eUndefined});
    colours[output.location] = attach(colour_format(output), vk::ImageLayout::eColorAttachmentOptimal);
  }
  const vk::AttachmentReference depth =
      attach(vk::Format::eD32Sfloat, vk::ImageLayout::eDepthStencilAttachmentOptimal);
  vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, nullptr, colours);
  subpass.pDepthStencilAttachment = &depth;
  return {device, vk::RenderPassCreateInfo({}, attachments, subpass)};
}

struct VertexAttributes {
  std::vector<vk::VertexInputAttributeDescription> attributes;
  std::optional<vk::VertexInputBindingDescription> binding;
};

VertexAttributes vertex_attributes(const std::vector<StageLocation>& inputs) {
  constexpr std::uint32_t attribute_bytes = 16;
  std::map<std::uint32_t, vk::Format> formats;
  for (const StageLocation& input : inputs) formats[input.location] = attribute_format(input);
  VertexAttributes made;
  std::uint32_t offset = 0;
  for (const auto& [location, format] : formats) {
    made.attributes.emplace_back(location, 0, format, offset);
    offset += attribute_bytes;
  }
  if (offset > 0) made.binding.emplace(0, offset, vk::VertexInputRate::eVertex);
  return made;
}

std::uint64_t whole_number(const vk::PipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
    case vk::PipelineExecutableStatisticFormatKHR::eBool32:
      return statistic.value.b32 != VK_FALSE ? 1 : 0;
    case vk::PipelineExecutableStatisticFormatKHR::eInt64:
      return static_cast<std::uint64_t>(std::max<std::int64_t>(0, statistic.value.i64));
    case vk::PipelineExecutableStatisticFormatKHR::eFloat64:
      return static_cast<std::uint64_t>(std::llround(std::max(0.0, statistic.value.f64)));
    case vk::PipelineExecutableStatisticFormatKHR::eUint64:
      break;
  }
  return statistic.value.u64;
}

std::vector<PipelineExecutable> executables_of(const vk::raii::Device& device,
                                               const vk::raii::Pipeline& pipeline) {
  using Stage = vk::ShaderStageFlagBits;
  std::vector<PipelineExecutable> executables;
  for (const vk::PipelineExecutablePropertiesKHR& properties :
       device.getPipelineExecutablePropertiesKHR({*pipeline})) {
    PipelineExecutable executable;
    executable.name = std::string(std::string_view(properties.name));
    executable.vertex = bool(properties.stages & Stage::eVertex);
    executable.fragment = bool(properties.stages & Stage::eFragment);
    executable.compute = bool(properties.stages & Stage::eCompute);
    executable.subgroup_size = properties.subgroupSize;
    const auto index = static_cast<std::uint32_t>(executables.size());
    for (const vk::PipelineExecutableStatisticKHR& statistic :
         device.getPipelineExecutableStatisticsKHR({*pipeline, index})) {
      executable.statistics.push_back({std::string(std::string_view(statistic.name)),
                                       std::string(std::string_view(statistic.description)),
                                       whole_number(statistic)});
    }
    executables.push_back(std::move(executable));
  }
  return executables;
}

template <typename Action>
auto asking(const DeviceInfo& info, Action&& action) {
  try {
    return action();
  } catch (const vk::SystemError& error) {
    throw EnvironmentError(info.name + ": makes no pipeline of this shader: " + error.what());
  }
}

vk::raii::Pipeline graphics_pipeline(const vk::raii::Device& device, const ShaderEntry& vertex,
                                     const ShaderEntry& fragment) {
  const PipelineInterface vertex_interface = shaders::pipeline_interface(vertex.spirv, vertex.entry);
  const PipelineInterface fragment_interface = shaders::pipeline_interface(fragment.spirv, fragment.entry);
  const Layout layout = make_layout(device, {&vertex_interface, &fragment_interface},
                                    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment);
  const vk::raii::RenderPass render_pass = make_render_pass(device, fragment_interface.outputs);
  const vk::raii::ShaderModule vertex_module(device, vk::ShaderModuleCreateInfo({}, vertex.spirv));
  const vk::raii::ShaderModule fragment_module(device, vk::ShaderModuleCreateInfo({}, fragment.spirv));
  const std::array stages{vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex,
                                                            *vertex_module, vertex.entry.c_str()),
                          vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment,
                                                            *fragment_module, fragment.entry.c_str())};
  const VertexAttributes attributes = vertex_attributes(vertex_interface.inputs);
  vk::PipelineVertexInputStateCreateInfo vertex_input;
  if (attributes.binding) {
    vertex_input.setVertexBindingDescriptions(*attributes.binding);
    vertex_input.setVertexAttributeDescriptions(attributes.attributes);
  }
  const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo one_viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.lineWidth = 1.0F;
  const vk::PipelineMultisampleStateCreateInfo one_sample;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, VK_TRUE, VK_TRUE, vk::CompareOp::eLessOrEqual);
  using Component = vk::ColorComponentFlagBits;
  vk::PipelineColorBlendAttachmentState overwrite;
  overwrite.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  const std::size_t colours =
      fragment_interface.outputs.empty() ? 0 : fragment_interface.outputs.back().location + 1;
  const std::vector<vk::PipelineColorBlendAttachmentState> overwrites(colours, overwrite);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, overwrites);
  const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);
  return {
      device, nullptr,
      vk::GraphicsPipelineCreateInfo(vk::PipelineCreateFlagBits::eCaptureStatisticsKHR, stages, &vertex_input,
                                     &triangles, nullptr, &one_viewport, &rasterization, &one_sample, &depth,
                                     &blend, &dynamic, *layout.pipeline, *render_pass)};
}

vk::raii::Pipeline compute_pipeline(const vk::raii::Device& device, const ShaderEntry& shader) {
  const PipelineInterface interface = shaders::pipeline_interface(shader.spirv, shader.entry);
  const Layout layout = make_layout(device, {&interface}, vk::ShaderStageFlagBits::eCompute);
  const vk::raii::ShaderModule module(device, vk::ShaderModuleCreateInfo({}, shader.spirv));
  const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                shader.entry.c_str());
  return {device, nullptr,
          vk::ComputePipelineCreateInfo(vk::PipelineCreateFlagBits::eCaptureStatisticsKHR, stage,
                                        *layout.pipeline)};
}

}  // namespace

StatisticsDevice::StatisticsDevice(const std::string& name) : state_(std::make_unique<State>(load_vulkan())) {
  Candidate chosen = starting_vulkan([this, &name] {
    state_->instance = make_instance(state_->context, nullptr);
    return choose(candidates_of(state_->instance), name);
  });
  state_->info = chosen.info;
  state_->device = starting_vulkan([&chosen] { return open_device(chosen); });
}

StatisticsDevice::~StatisticsDevice() = default;
StatisticsDevice::StatisticsDevice(StatisticsDevice&&) noexcept = default;
StatisticsDevice& StatisticsDevice::operator=(StatisticsDevice&&) noexcept = default;

const DeviceInfo& StatisticsDevice::info() const {
  return state_->info;
}

std::vector<PipelineExecutable> StatisticsDevice::compute(const ShaderEntry& shader) const {
  return asking(state_->info,
                [&] { return executables_of(state_->device, compute_pipeline(state_->device, shader)); });
}

std::vector<PipelineExecutable> StatisticsDevice::graphics(const ShaderEntry& vertex,
                                                           const ShaderEntry& fragment) const {
  return asking(state_->info, [&] {
    return executables_of(state_->device, graphics_pipeline(state_->device, vertex, fragment));
  });
}

}  // namespace penumbra::gpu
