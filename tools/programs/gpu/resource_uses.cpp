#include "gpu/resource_uses.h"

#include <stdexcept>

namespace penumbra::gpu {
namespace {

constexpr vk::AccessFlags every_access = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;

vk::ImageMemoryBarrier layout_change(ImageState& image, int mip, int layer, vk::ImageLayout wanted) {
  vk::ImageMemoryBarrier barrier(every_access, every_access, image.layout(mip, layer), wanted,
                                 VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *image.image,
                                 image.range({mip, 1, layer, 1}));
  image.layout(mip, layer) = wanted;
  return barrier;
}

template <typename Visit>
void for_each_part(const ImageParts& parts, Visit visit) {
  for (int mip = parts.first_mip; mip < parts.first_mip + parts.mips; ++mip)
    for (int layer = parts.first_layer; layer < parts.first_layer + parts.layers; ++layer) visit(mip, layer);
}

// A pass may have a part that it writes only once, and a part that it reads in one layout.
void check_once(const ResourceUses& uses) {
  std::map<std::tuple<const ImageState*, int, int>, const ImageUse*> used;
  for (const ImageUse& use : uses.images) {
    for_each_part(use.parts, [&](int mip, int layer) {
      const auto [other, first] = used.emplace(std::tuple(use.image.get(), mip, layer), &use);
      if (first ||
          (!use.access.writes && !other->second->access.writes && use.layout == other->second->layout))
        return;
      throw std::logic_error("a pass reads and writes mip level " + std::to_string(mip) + " of layer " +
                             std::to_string(layer) + " of one image");
    });
  }
}

}  // namespace

bool Barriers::must_wait(const Past& past, const Access& access, Wait& wait) {
  const bool visible = (access.stages & past.seen.stages) == access.stages &&
                       (access.access & past.seen.access) == access.access;
  const bool after_write = bool(past.write.stages) && !visible;
  const bool after_read = access.writes && bool(past.read);
  if (!after_write && !after_read) return false;
  wait.from |= past.write.stages | (access.writes ? past.read : vk::PipelineStageFlags());
  wait.to |= access.stages;
  wait.written |= past.write.access;
  wait.wanted |= access.access;
  return true;
}

void Barriers::remember(Past& past, const Access& access, bool waited) {
  if (access.writes) {
    past = {access, {}, {}};
    return;
  }
  past.read |= access.stages;
  if (!waited) return;
  past.seen.stages |= access.stages;
  past.seen.access |= access.access;
}

bool Barriers::before(const ResourceUses& uses, const vk::raii::CommandBuffer& commands) {
  check_once(uses);
  Wait wait;
  bool waits = false;
  std::vector<vk::ImageMemoryBarrier> changes;
  for (const BufferUse& use : uses.buffers) {
    Past& past = buffers_[use.buffer.get()];
    const bool must = must_wait(past, use.access, wait);
    remember(past, use.access, must);
    waits = waits || must;
  }
  for (const ImageUse& use : uses.images) {
    for_each_part(use.parts, [&](int mip, int layer) {
      Past& past = parts_[{use.image.get(), mip, layer}];
      bool must = must_wait(past, use.access, wait);
      if (use.image->layout(mip, layer) != use.layout) {
        wait.from |= past.write.stages | past.read;
        wait.to |= use.access.stages;
        changes.push_back(layout_change(*use.image, mip, layer, use.layout));
        must = true;
      }
      remember(past, use.access, must);
      waits = waits || must;
    });
  }
  if (!waits) return false;
  if (!wait.from) wait.from = vk::PipelineStageFlagBits::eAllCommands;
  const vk::MemoryBarrier memory(wait.written, wait.wanted);
  commands.pipelineBarrier(wait.from, wait.to, {}, memory, nullptr, changes);
  return true;
}

void move_to(ImageState& image, const ImageParts& parts, vk::ImageLayout wanted,
             const vk::raii::CommandBuffer& commands) {
  std::vector<vk::ImageMemoryBarrier> changes;
  for_each_part(parts, [&](int mip, int layer) {
    if (image.layout(mip, layer) != wanted) changes.push_back(layout_change(image, mip, layer, wanted));
  });
  if (changes.empty()) return;
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands, vk::PipelineStageFlagBits::eAllCommands,
                           {}, nullptr, nullptr, changes);
}

}  // namespace penumbra::gpu
