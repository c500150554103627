#include "gpu/raster_pass.h"

#include <algorithm>
#include <stdexcept>

#include "gpu/pass_state.h"

namespace penumbra::gpu {
namespace {

constexpr std::uint32_t push_constant_bytes = 128;  // the size that every Vulkan device has
constexpr Access colour_access{
    vk::PipelineStageFlagBits::eColorAttachmentOutput,
    vk::AccessFlagBits::eColorAttachmentRead | vk::AccessFlagBits::eColorAttachmentWrite, true};
constexpr Access depth_access{
    vk::PipelineStageFlagBits::eEarlyFragmentTests | vk::PipelineStageFlagBits::eLateFragmentTests,
    vk::AccessFlagBits::eDepthStencilAttachmentRead | vk::AccessFlagBits::eDepthStencilAttachmentWrite, true};

constexpr Access input_access{vk::PipelineStageFlagBits::eVertexInput,
                              vk::AccessFlagBits::eVertexAttributeRead, false};
constexpr Access index_access{vk::PipelineStageFlagBits::eVertexInput, vk::AccessFlagBits::eIndexRead, false};

vk::Format format_of(const VertexInput& input) {
  constexpr std::array formats{vk::Format::eR32Sfloat, vk::Format::eR32G32Sfloat,
                               vk::Format::eR32G32B32Sfloat, vk::Format::eR32G32B32A32Sfloat};
  return formats.at(static_cast<std::size_t>(input.components - 1));
}

vk::ImageLayout layout_of(Format format) {
  return is_depth(format) ? vk::ImageLayout::eDepthStencilAttachmentOptimal
                          : vk::ImageLayout::eColorAttachmentOptimal;
}

struct Attachments {
  std::vector<vk::AttachmentDescription> descriptions;
  std::vector<vk::AttachmentReference> colours;
  std::vector<vk::AttachmentReference> resolves;
  std::vector<vk::AttachmentReference> depth;  // one or none

  void add(const DeviceState& device, Format format, int samples, vk::AttachmentLoadOp load,
           std::vector<vk::AttachmentReference>& list) {
    vk::AttachmentDescription description;
    description.format = need_texel_format(device, format).format;
    description.samples = static_cast<vk::SampleCountFlagBits>(samples);
    description.loadOp = load;
    description.storeOp = vk::AttachmentStoreOp::eStore;
    description.stencilLoadOp = has_stencil(format) ? load : vk::AttachmentLoadOp::eDontCare;
    description.stencilStoreOp =
        has_stencil(format) ? vk::AttachmentStoreOp::eStore : vk::AttachmentStoreOp::eDontCare;
    description.initialLayout = description.finalLayout = layout_of(format);
    list.emplace_back(std::uint32_t(descriptions.size()), layout_of(format));
    descriptions.push_back(description);
  }
};

vk::raii::RenderPass make_render_pass(const DeviceState& device, const RasterShaders& shaders) {
  const vk::AttachmentLoadOp load = shaders.keep ? vk::AttachmentLoadOp::eLoad : vk::AttachmentLoadOp::eClear;
  Attachments attachments;
  for (const Format colour : shaders.colours)
    attachments.add(device, colour, shaders.samples, load, attachments.colours);
  if (shaders.resolve)
    for (const Format colour : shaders.colours)
      attachments.add(device, colour, 1, vk::AttachmentLoadOp::eDontCare, attachments.resolves);
  if (shaders.depth)
    attachments.add(device, *shaders.depth, shaders.samples,
                    shaders.keep_depth ? vk::AttachmentLoadOp::eLoad : load, attachments.depth);
  vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, nullptr, attachments.colours);
  if (shaders.resolve) subpass.pResolveAttachments = attachments.resolves.data();
  if (shaders.depth) subpass.pDepthStencilAttachment = attachments.depth.data();
  return {device.device, vk::RenderPassCreateInfo({}, attachments.descriptions, subpass)};
}

vk::PipelineColorBlendAttachmentState blend_of(Blend blend) {
  using Component = vk::ColorComponentFlagBits;
  using Factor = vk::BlendFactor;
  vk::PipelineColorBlendAttachmentState state;
  state.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  state.blendEnable = blend != Blend::none;
  state.colorBlendOp = blend == Blend::smallest  ? vk::BlendOp::eMin
                       : blend == Blend::largest ? vk::BlendOp::eMax
                                                 : vk::BlendOp::eAdd;
  state.alphaBlendOp = state.colorBlendOp;
  state.srcColorBlendFactor = state.srcAlphaBlendFactor =
      blend == Blend::alpha ? Factor::eSrcAlpha : Factor::eOne;
  state.dstColorBlendFactor = state.dstAlphaBlendFactor =
      blend == Blend::alpha ? Factor::eOneMinusSrcAlpha : Factor::eOne;
  return state;
}

vk::CompareOp compare_of(DepthTest test) {
  switch (test) {
    case DepthTest::less:
      return vk::CompareOp::eLess;
    case DepthTest::greater:
      return vk::CompareOp::eGreater;
    case DepthTest::less_equal:
      return vk::CompareOp::eLessOrEqual;
    case DepthTest::greater_equal:
      return vk::CompareOp::eGreaterOrEqual;
    case DepthTest::equal:
      return vk::CompareOp::eEqual;
    case DepthTest::always:
      break;
  }
  return vk::CompareOp::eAlways;
}

vk::StencilOpState stencil_of(const StencilFace& face, const StencilState& state) {
  using Op = vk::StencilOp;
  constexpr std::array operations{Op::eKeep,
                                  Op::eZero,
                                  Op::eReplace,
                                  Op::eIncrementAndClamp,
                                  Op::eDecrementAndClamp,
                                  Op::eIncrementAndWrap,
                                  Op::eDecrementAndWrap,
                                  Op::eInvert};
  constexpr std::array tests{vk::CompareOp::eNever,          vk::CompareOp::eLess,
                             vk::CompareOp::eEqual,          vk::CompareOp::eLessOrEqual,
                             vk::CompareOp::eGreater,        vk::CompareOp::eNotEqual,
                             vk::CompareOp::eGreaterOrEqual, vk::CompareOp::eAlways};
  const auto operation = [&](StencilOperation one) { return operations.at(static_cast<std::size_t>(one)); };
  return {operation(face.fail),
          operation(face.pass),
          operation(face.depth_fail),
          tests.at(static_cast<std::size_t>(face.test)),
          state.read_mask,
          state.write_mask,
          state.reference};
}

std::vector<vk::PipelineColorBlendAttachmentState> blends_of(const RasterShaders& shaders) {
  std::vector<vk::PipelineColorBlendAttachmentState> states;
  for (std::size_t at = 0; at < shaders.colours.size(); ++at)
    states.push_back(blend_of(at < shaders.blends.size() ? shaders.blends[at] : Blend::none));
  return states;
}

void check(const Device& device, const RasterShaders& shaders) {
  const DeviceState& state = *device.state();
  for (const VertexInput& input : shaders.inputs)
    if (input.components < 1 || input.components > 4)
      throw std::invalid_argument("a vertex input has 1 to 4 components");
  if (shaders.vertex.empty()) throw std::invalid_argument("a raster pass without a vertex shader");
  if (shaders.colours.empty() && !shaders.depth)
    throw std::invalid_argument("a raster pass has a depth target, colour targets, or both");
  if (shaders.stencil && !(shaders.depth && has_stencil(*shaders.depth)))
    throw std::invalid_argument("a raster pass with a stencil test and no stencil");
  if (shaders.blends.size() > shaders.colours.size())
    throw std::invalid_argument("a raster pass with more blends than colours");
  if (shaders.resolve && (shaders.samples == 1 || shaders.colours.empty()))
    throw std::invalid_argument("only colours with several samples are resolved");
  const std::string& name = device.info().name;
  if (shaders.colours.size() > state.limits.maxColorAttachments)
    throw EnvironmentError(name + ": a pass has at most " + std::to_string(state.limits.maxColorAttachments) +
                           " colour targets here");
  if (shaders.depth_clamp && !state.features.depthClamp)
    throw EnvironmentError(name + ": no depth clamp here");
  if (shaders.shade_each_sample && !state.features.sampleRateShading)
    throw EnvironmentError(name + ": no shading of each sample here");
  if (std::any_of(shaders.blends.begin(), shaders.blends.end(),
                  [&](Blend blend) { return blend != shaders.blends.front(); }) &&
      !state.features.independentBlend)
    throw EnvironmentError(name + ": all colour targets blend alike here");
  for (std::size_t at = 0; at < shaders.colours.size(); ++at) {
    const FormatUses uses = uses_of(state, shaders.colours[at]);
    const bool blends = at < shaders.blends.size() && shaders.blends[at] != Blend::none;
    if (!uses.target || is_depth(shaders.colours[at]) || (blends && !uses.blended))
      throw EnvironmentError(name + ": " + gpu::name(shaders.colours[at]) + " images are no targets" +
                             (blends ? " that blend" : "") + " here");
  }
}

std::shared_ptr<RasterState> make_state(const Device& device, const RasterShaders& shaders) {
  check(device, shaders);
  auto state = std::make_shared<RasterState>();
  std::vector<StageModule> modules{{shaders.vertex, vk::ShaderStageFlagBits::eVertex}};
  if (!shaders.fragment.empty()) modules.push_back({shaders.fragment, vk::ShaderStageFlagBits::eFragment});
  state->interface = make_interface(device.state(), modules, push_constant_bytes);
  state->shaders = shaders;
  state->shaders.vertex = std::move(modules.front().spirv);
  if (!shaders.fragment.empty()) state->shaders.fragment = std::move(modules.back().spirv);
  guarded(*device.state(), "make a render pass",
          [&] { state->render_pass = make_render_pass(*device.state(), shaders); });
  return state;
}

const RasterTarget& first_target(const RasterTargets& targets) {
  return targets.colours.empty() ? targets.depth : targets.colours.front();
}

vk::Extent2D extent_of(const RasterTarget& target) {
  const vk::Extent3D extent = target.image->state()->extent(target.mip);
  return {extent.width, extent.height};
}

void check_target(const RasterTarget& target, Format format, int samples, const vk::Extent2D& extent) {
  if (target.image == nullptr) throw std::logic_error("a raster pass without one of its targets");
  const ImageShape& shape = target.image->shape();
  if (target.mip < 0 || target.mip >= shape.mips || target.layer < 0 || target.layer >= shape.layers)
    throw std::invalid_argument("a target's mip level or layer that its image does not have");
  if (shape.depth > 1) throw std::logic_error("a raster pass draws into 2D images");
  if (shape.format != format)
    throw std::logic_error("a target has another format than the raster pass was made for");
  if (shape.samples != samples)
    throw std::logic_error("a target has " + std::to_string(shape.samples) + " samples, not " +
                           std::to_string(samples));
  if (extent_of(target) != extent) throw std::logic_error("targets of different sizes");
}

void check(const RasterShaders& shaders, const RasterTargets& targets) {
  const bool depth_fits = (targets.depth.image != nullptr) == shaders.depth.has_value();
  const std::size_t resolves = shaders.resolve ? shaders.colours.size() : 0;
  if (targets.colours.size() != shaders.colours.size() || !depth_fits ||
      targets.resolves.size() != resolves ||
      (!targets.clear_colours.empty() && targets.clear_colours.size() != shaders.colours.size()))
    throw std::logic_error("the targets are not those the raster pass was made for");
  if (first_target(targets).image == nullptr)
    throw std::logic_error("a raster pass without one of its targets");
  const vk::Extent2D extent = extent_of(first_target(targets));
  for (std::size_t at = 0; at < targets.colours.size(); ++at)
    check_target(targets.colours[at], shaders.colours[at], shaders.samples, extent);
  for (std::size_t at = 0; at < targets.resolves.size(); ++at)
    check_target(targets.resolves[at], shaders.colours[at], 1, extent);
  if (shaders.depth) check_target(targets.depth, *shaders.depth, shaders.samples, extent);
}

void check(const RasterTile& tile, const vk::Extent2D& extent) {
  const bool inside = tile.x >= 0 && tile.y >= 0 && tile.width > 0 && tile.height > 0 &&
                      tile.x + tile.width <= int(extent.width) && tile.y + tile.height <= int(extent.height);
  if (!inside) throw std::invalid_argument("a tile outside its targets");
  if (tile.push_constants.size() > push_constant_bytes || tile.push_constants.size() % 4 != 0)
    throw std::invalid_argument("push constants are whole words, at most 128 bytes");
}

// No vertex is read beyond its buffer; the caller is responsible for the values of indices.
void check(const RasterShaders& shaders, const std::vector<RasterTile>& tiles, const VertexStreams& streams) {
  if (streams.inputs.size() != shaders.inputs.size())
    throw std::logic_error("a draw has a buffer for each vertex input");
  const auto holds = [&](const Buffer* buffer, std::size_t bytes) {
    if (buffer == nullptr) throw std::logic_error("a draw without one of its vertex buffers");
    for (const RasterTile& tile : tiles)
      if (buffer->size_bytes() / bytes < tile.vertex_count)
        throw std::invalid_argument("a draw of more vertices than its buffers hold");
  };
  if (streams.indices != nullptr) return holds(streams.indices, sizeof(std::uint32_t));
  for (std::size_t at = 0; at < streams.inputs.size(); ++at)
    holds(streams.inputs[at], sizeof(float) * static_cast<std::size_t>(shaders.inputs[at].components));
}

// Its members are kept together so that a draw that never ends keeps all that it uses.
struct Draw {
  std::shared_ptr<RasterState> pass;
  std::vector<std::shared_ptr<ImageState>> images;
  std::vector<vk::ClearValue> clears;
  std::vector<RasterTile> tiles;
  vk::Extent2D extent;
  std::vector<std::shared_ptr<BufferState>> vertices;
  std::shared_ptr<BufferState> indices;  // null: vertices in order
  vk::raii::Framebuffer framebuffer = nullptr;

  void add(const VertexStreams& streams, ResourceUses& uses) {
    for (const Buffer* buffer : streams.inputs) {
      vertices.push_back(buffer->state());
      uses.buffers.push_back({buffer->state(), input_access});
    }
    if (streams.indices == nullptr) return;
    indices = streams.indices->state();
    uses.buffers.push_back({indices, index_access});
  }

  void add(const RasterTarget& target, const Access& access, vk::ClearValue clear,
           std::vector<vk::ImageView>& views, ResourceUses& uses) {
    const std::shared_ptr<ImageState>& image = target.image->state();
    const ImageParts part{target.mip, 1, target.layer, 1};
    images.push_back(image);
    clears.push_back(clear);
    views.push_back(image->view(part, vk::ImageViewType::e2D, true));
    uses.images.push_back({image, part, layout_of(image->shape.format), access});
  }
};

vk::ClearValue clear_colour(const RasterTargets& targets, std::size_t at) {
  if (at < targets.clear_colours.size()) return vk::ClearColorValue(targets.clear_colours[at]);
  return vk::ClearColorValue(std::array<float, 4>{0.0F, 0.0F, 0.0F, 0.0F});  // integers have the same bits
}

void record(const Draw& draw, const vk::raii::CommandBuffer& commands) {
  RasterState& pass = *draw.pass;
  commands.beginRenderPass(
      vk::RenderPassBeginInfo(*pass.render_pass, *draw.framebuffer, {{0, 0}, draw.extent}, draw.clears),
      vk::SubpassContents::eInline);
  commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pass.pipeline());
  std::uint32_t binding = 0;
  for (const std::shared_ptr<BufferState>& buffer : draw.vertices)
    commands.bindVertexBuffers(binding++, *buffer->allocation.buffer, vk::DeviceSize(0));
  if (draw.indices) commands.bindIndexBuffer(*draw.indices->allocation.buffer, 0, vk::IndexType::eUint32);
  for (const RasterTile& tile : draw.tiles) {
    commands.setViewport(
        0, vk::Viewport(float(tile.x), float(tile.y), float(tile.width), float(tile.height), 0.0F, 1.0F));
    commands.setScissor(
        0, vk::Rect2D({tile.x, tile.y}, {std::uint32_t(tile.width), std::uint32_t(tile.height)}));
    if (!tile.push_constants.empty())
      commands.pushConstants<std::byte>(*pass.interface->pipeline_layout, pass.interface->stages, 0,
                                        tile.push_constants);
    if (draw.indices)
      commands.drawIndexed(tile.vertex_count, 1, 0, 0, 0);
    else
      commands.draw(tile.vertex_count, 1, 0, 0);
  }
  commands.endRenderPass();
}

}  // namespace

vk::Pipeline RasterState::pipeline() {
  if (*pipeline_) return *pipeline_;
  const vk::raii::Device& device = interface->device->device;
  const vk::raii::ShaderModule vertex(device, vk::ShaderModuleCreateInfo({}, shaders.vertex));
  vk::raii::ShaderModule fragment = nullptr;
  std::vector<vk::PipelineShaderStageCreateInfo> stages;
  stages.emplace_back(vk::PipelineShaderStageCreateFlags(), vk::ShaderStageFlagBits::eVertex, *vertex,
                      shaders.vertex_entry.c_str());
  if (!shaders.fragment.empty()) {
    fragment = vk::raii::ShaderModule(device, vk::ShaderModuleCreateInfo({}, shaders.fragment));
    stages.emplace_back(vk::PipelineShaderStageCreateFlags(), vk::ShaderStageFlagBits::eFragment, *fragment,
                        shaders.fragment_entry.c_str());
  }
  std::vector<vk::VertexInputBindingDescription> bindings;
  std::vector<vk::VertexInputAttributeDescription> attributes;
  for (const VertexInput& input : shaders.inputs) {
    const auto binding = static_cast<std::uint32_t>(bindings.size());
    bindings.emplace_back(binding, static_cast<std::uint32_t>(input.components) * 4U);
    attributes.emplace_back(input.location, binding, format_of(input), 0U);
  }
  const vk::PipelineVertexInputStateCreateInfo vertex_input({}, bindings, attributes);
  const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo one_viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.depthClampEnable = shaders.depth_clamp;
  rasterization.depthBiasEnable = shaders.constant_depth_bias != 0.0F || shaders.slope_depth_bias != 0.0F;
  rasterization.depthBiasConstantFactor = shaders.constant_depth_bias;
  rasterization.depthBiasSlopeFactor = shaders.slope_depth_bias;
  rasterization.frontFace = vk::FrontFace::eClockwise;
  rasterization.lineWidth = 1.0F;
  vk::PipelineMultisampleStateCreateInfo samples;
  samples.rasterizationSamples = static_cast<vk::SampleCountFlagBits>(shaders.samples);
  samples.sampleShadingEnable = shaders.shade_each_sample;
  samples.minSampleShading = 1.0F;
  vk::PipelineDepthStencilStateCreateInfo depth({}, shaders.depth.has_value(),
                                                shaders.depth.has_value() && shaders.depth_write,
                                                compare_of(shaders.depth_test));
  depth.stencilTestEnable = shaders.stencil.has_value();
  if (shaders.stencil) {
    depth.front = stencil_of(shaders.stencil->front, *shaders.stencil);
    depth.back = stencil_of(shaders.stencil->back, *shaders.stencil);
  }
  const std::vector<vk::PipelineColorBlendAttachmentState> blends = blends_of(shaders);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, blends);
  const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);
  pipeline_ =
      vk::raii::Pipeline(device, nullptr,
                         vk::GraphicsPipelineCreateInfo(
                             {}, stages, &vertex_input, &triangles, nullptr, &one_viewport, &rasterization,
                             &samples, &depth, &blend, &dynamic, *interface->pipeline_layout, *render_pass));
  return *pipeline_;
}

SequenceStep raster_step(const std::shared_ptr<RasterState>& pass, const Bindings& bindings,
                         const RasterTargets& targets, const std::vector<RasterTile>& tiles,
                         const VertexStreams& streams) {
  check(pass->shaders, targets);
  check(pass->shaders, tiles, streams);
  const auto draw = std::make_shared<Draw>();
  draw->pass = pass;
  draw->tiles = tiles;
  draw->extent = extent_of(first_target(targets));
  for (const RasterTile& tile : tiles) check(tile, draw->extent);
  SequenceStep step = step_with(bindings, *pass->interface, vk::PipelineBindPoint::eGraphics);
  draw->add(streams, step.uses);
  std::vector<vk::ImageView> views;
  for (std::size_t at = 0; at < targets.colours.size(); ++at)
    draw->add(targets.colours[at], colour_access, clear_colour(targets, at), views, step.uses);
  for (const RasterTarget& target : targets.resolves) draw->add(target, colour_access, {}, views, step.uses);
  if (targets.depth.image != nullptr)
    draw->add(targets.depth, depth_access, vk::ClearDepthStencilValue(targets.clear_depth, 0), views,
              step.uses);
  const DeviceState& device = *pass->interface->device;
  guarded(device, "prepare a raster pass", [&] {
    draw->framebuffer = vk::raii::Framebuffer(
        device.device,
        vk::FramebufferCreateInfo({}, *pass->render_pass, views, draw->extent.width, draw->extent.height, 1));
  });
  step.used = draw;
  step.record = [draw](const vk::raii::CommandBuffer& commands) { record(*draw, commands); };
  return step;
}

RasterPass::RasterPass(const Device& device, const RasterShaders& shaders)
    : state_(make_state(device, shaders)), bindings_(state_->interface) {}

Bindings RasterPass::more_bindings() const {
  return Bindings(state_->interface);
}

double RasterPass::draw(const RasterTargets& targets, const std::vector<RasterTile>& tiles,
                        const VertexStreams& streams) {
  Sequence once(state_->interface->device);
  once.draw(*this, bindings_, targets, tiles, streams);
  return once.run().front();
}

}  // namespace penumbra::gpu
