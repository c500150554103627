#include "gpu/raster_pass.h"

#include <stdexcept>

#include "gpu/bindings_state.h"

namespace penumbra::gpu {
namespace {

constexpr std::uint32_t push_constant_bytes = 128;  // what every Vulkan device has
constexpr vk::ShaderStageFlags both_stages =
    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

struct Attachments {
  std::vector<vk::AttachmentDescription> descriptions;
  std::vector<vk::AttachmentReference> colours;
  std::optional<vk::AttachmentReference> depth;
};

void attach(Attachments& attachments, vk::Format format, vk::ImageLayout layout) {
  vk::AttachmentDescription description;
  description.format = format;
  description.loadOp = vk::AttachmentLoadOp::eClear;
  description.storeOp = vk::AttachmentStoreOp::eStore;
  description.stencilLoadOp = vk::AttachmentLoadOp::eDontCare;
  description.stencilStoreOp = vk::AttachmentStoreOp::eDontCare;
  description.initialLayout = description.finalLayout = layout;
  attachments.descriptions.push_back(description);
}

vk::Format need(const DeviceState& device, Format format) {
  const std::optional<TexelFormat> texel = texel_format_of(device, format);
  if (!texel) throw EnvironmentError(device.info.name + ": no " + name(format) + " images here");
  return texel->format;
}

}  // namespace

struct RasterState {
  RasterState(const Device& device, RasterShaders given) : bindings(device), shaders(std::move(given)) {}

  Bindings bindings;
  RasterShaders shaders;
  vk::raii::RenderPass render_pass = nullptr;
  vk::raii::Pipeline pipeline = nullptr;

  void make_render_pass();
  void make_pipeline();
  vk::raii::Framebuffer make_framebuffer(const RasterTargets& targets) const;
};

void RasterState::make_render_pass() {
  const DeviceState& device = *bindings.state()->device;
  Attachments attachments;
  for (const Format colour : shaders.colours) {
    attachments.colours.emplace_back(std::uint32_t(attachments.descriptions.size()),
                                     vk::ImageLayout::eColorAttachmentOptimal);
    attach(attachments, need(device, colour), vk::ImageLayout::eColorAttachmentOptimal);
  }
  if (shaders.depth) {
    attachments.depth.emplace(std::uint32_t(attachments.descriptions.size()),
                              vk::ImageLayout::eDepthStencilAttachmentOptimal);
    attach(attachments, need(device, *shaders.depth), vk::ImageLayout::eDepthStencilAttachmentOptimal);
  }
  vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, nullptr, attachments.colours);
  if (attachments.depth) subpass.pDepthStencilAttachment = &*attachments.depth;
  render_pass =
      vk::raii::RenderPass(device.device, vk::RenderPassCreateInfo({}, attachments.descriptions, subpass));
}

void RasterState::make_pipeline() {
  BindingsState& bound = *bindings.state();
  const vk::raii::Device& device = bound.device->device;
  require_bound(bound, shaders.vertex);
  if (!shaders.fragment.empty()) require_bound(bound, shaders.fragment);
  bound.freeze(both_stages, push_constant_bytes);
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
  const vk::PipelineVertexInputStateCreateInfo no_vertex_input;
  const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo one_viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.depthClampEnable = shaders.depth_clamp;
  rasterization.depthBiasEnable = shaders.constant_depth_bias != 0.0F || shaders.slope_depth_bias != 0.0F;
  rasterization.depthBiasConstantFactor = shaders.constant_depth_bias;
  rasterization.depthBiasSlopeFactor = shaders.slope_depth_bias;
  rasterization.lineWidth = 1.0F;
  const vk::PipelineMultisampleStateCreateInfo one_sample;
  const vk::CompareOp nearer =
      shaders.depth_test == DepthTest::less ? vk::CompareOp::eLess : vk::CompareOp::eGreater;
  const vk::PipelineDepthStencilStateCreateInfo depth({}, shaders.depth.has_value(),
                                                      shaders.depth.has_value(), nearer);
  using Component = vk::ColorComponentFlagBits;
  vk::PipelineColorBlendAttachmentState overwrite;
  overwrite.colorWriteMask = Component::eR | Component::eG | Component::eB | Component::eA;
  const std::vector<vk::PipelineColorBlendAttachmentState> overwrites(shaders.colours.size(), overwrite);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, overwrites);
  const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);
  pipeline =
      vk::raii::Pipeline(device, nullptr,
                         vk::GraphicsPipelineCreateInfo(
                             {}, stages, &no_vertex_input, &triangles, nullptr, &one_viewport, &rasterization,
                             &one_sample, &depth, &blend, &dynamic, *bound.pipeline_layout, *render_pass));
}

vk::raii::Framebuffer RasterState::make_framebuffer(const RasterTargets& targets) const {
  std::vector<const Image*> images = targets.colours;
  if (targets.depth != nullptr) images.push_back(targets.depth);
  std::vector<vk::ImageView> views;
  views.reserve(images.size());
  for (const Image* image : images) views.push_back(*image->state()->target_view);
  const vk::Extent2D extent = images.front()->state()->extent;
  return {bindings.state()->device->device,
          vk::FramebufferCreateInfo({}, *render_pass, views, extent.width, extent.height, 1)};
}

namespace {

const Image& first_target(const RasterTargets& targets) {
  if (!targets.colours.empty()) return *targets.colours.front();
  if (targets.depth == nullptr) throw std::logic_error("a raster pass without a target");
  return *targets.depth;
}

void check(const RasterShaders& shaders, const RasterTargets& targets) {
  const bool depth_fits = (targets.depth != nullptr) == shaders.depth.has_value() &&
                          (targets.depth == nullptr || targets.depth->format() == *shaders.depth);
  if (targets.colours.size() != shaders.colours.size() || !depth_fits) {
    throw std::logic_error("the targets are not those the raster pass was made for");
  }
  for (std::size_t at = 0; at < targets.colours.size(); ++at) {
    if (targets.colours[at]->format() != shaders.colours[at]) {
      throw std::logic_error("a colour target has another format than the raster pass was made for");
    }
  }
  const Image& first = first_target(targets);
  for (const Image* image : targets.colours) {
    if (image->width() != first.width() || image->height() != first.height()) {
      throw std::logic_error("targets of different sizes");
    }
  }
  if (targets.depth != nullptr &&
      (targets.depth->width() != first.width() || targets.depth->height() != first.height())) {
    throw std::logic_error("targets of different sizes");
  }
}

void check(const RasterTile& tile, const vk::Extent2D& extent) {
  const bool inside = tile.x >= 0 && tile.y >= 0 && tile.width > 0 && tile.height > 0 &&
                      tile.x + tile.width <= int(extent.width) && tile.y + tile.height <= int(extent.height);
  if (!inside) throw std::invalid_argument("a tile outside its targets");
  if (tile.push_constants.size() > push_constant_bytes || tile.push_constants.size() % 4 != 0) {
    throw std::invalid_argument("push constants are whole words, at most 128 bytes");
  }
}

}  // namespace

RasterPass::RasterPass(const Device& device, const RasterShaders& shaders)
    : state_(std::make_shared<RasterState>(device, shaders)) {
  if (shaders.vertex.empty()) throw std::invalid_argument("a raster pass without a vertex shader");
  if (shaders.colours.size() > 2 || (shaders.colours.empty() && !shaders.depth)) {
    throw std::invalid_argument("a raster pass has one depth target, up to two colour targets, or both");
  }
  if (shaders.depth_clamp && !device.state()->features.depthClamp) {
    throw EnvironmentError(device.info().name + ": no depth clamp here");
  }
  guarded(*device.state(), "make a render pass", [this] { state_->make_render_pass(); });
}

RasterPass::~RasterPass() = default;
RasterPass::RasterPass(RasterPass&&) noexcept = default;
RasterPass& RasterPass::operator=(RasterPass&&) noexcept = default;

Bindings& RasterPass::bindings() {
  return state_->bindings;
}

double RasterPass::draw(const RasterTargets& targets, const std::vector<RasterTile>& tiles) {
  check(state_->shaders, targets);
  const Image& first = first_target(targets);
  const vk::Extent2D extent = first.state()->extent;
  for (const RasterTile& tile : tiles) check(tile, extent);

  // Kept together so that a draw that never ends keeps all it uses.
  struct Draw {
    std::shared_ptr<RasterState> pass;
    std::vector<std::shared_ptr<ImageState>> targets;
    vk::raii::Framebuffer framebuffer = nullptr;
  };
  const auto draw = std::make_shared<Draw>(Draw{state_, {}, nullptr});
  std::vector<vk::ClearValue> clears(targets.colours.size(),
                                     vk::ClearColorValue(std::array<float, 4>{0.0F, 0.0F, 0.0F, 0.0F}));
  for (const Image* colour : targets.colours) draw->targets.push_back(colour->state());
  if (targets.depth != nullptr) {
    draw->targets.push_back(targets.depth->state());
    clears.emplace_back(vk::ClearDepthStencilValue(targets.clear_depth, 0));
  }

  BindingsState& bound = *state_->bindings.state();
  DeviceState& device = *bound.device;
  const auto record = [&](const vk::raii::CommandBuffer& commands) {
    bound.use(vk::PipelineBindPoint::eGraphics, commands);
    for (const std::shared_ptr<ImageState>& target : draw->targets) {
      target->move_to(is_depth(target->format) ? vk::ImageLayout::eDepthStencilAttachmentOptimal
                                               : vk::ImageLayout::eColorAttachmentOptimal,
                      commands);
    }
    device.mark_begin(commands);
    commands.beginRenderPass(
        vk::RenderPassBeginInfo(*state_->render_pass, *draw->framebuffer, {{0, 0}, extent}, clears),
        vk::SubpassContents::eInline);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *state_->pipeline);
    for (const RasterTile& tile : tiles) {
      commands.setViewport(
          0, vk::Viewport(float(tile.x), float(tile.y), float(tile.width), float(tile.height), 0.0F, 1.0F));
      commands.setScissor(
          0, vk::Rect2D({tile.x, tile.y}, {std::uint32_t(tile.width), std::uint32_t(tile.height)}));
      if (!tile.push_constants.empty()) {
        commands.pushConstants<std::byte>(*bound.pipeline_layout, both_stages, 0, tile.push_constants);
      }
      commands.draw(tile.vertex_count, 1, 0, 0);
    }
    commands.endRenderPass();
    device.mark_end(commands);
  };
  return guarded(device, "run a raster pass", [&] {
    if (!*state_->pipeline) state_->make_pipeline();
    draw->framebuffer = state_->make_framebuffer(targets);
    bound.write_descriptors();
    return device.submit(record, draw);
  });
}

}  // namespace penumbra::gpu
