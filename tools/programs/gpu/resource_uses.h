// What the steps of a submission read and write, and the barriers that follow from it. Internal to this
// folder.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "gpu/resource_state.h"

namespace penumbra::gpu {

struct Access {
  vk::PipelineStageFlags stages;
  vk::AccessFlags access;
  bool writes = false;
};

struct BufferUse {
  std::shared_ptr<BufferState> buffer;
  Access access;
};

struct ImageUse {
  std::shared_ptr<ImageState> image;
  ImageParts parts;
  vk::ImageLayout layout = vk::ImageLayout::eGeneral;
  Access access;
};

struct ResourceUses {
  std::vector<BufferUse> buffers;
  std::vector<ImageUse> images;
};

// Of one submission, which begins and ends with a full barrier (DeviceState::submit).
class Barriers {
 public:
  // Records what must stand before a step with these uses: memory written before is made visible, and images
  // change to the layouts wanted. True when there is anything to wait for. Throws std::logic_error when the
  // step itself reads one part of an image that it writes as something else.
  bool before(const ResourceUses& uses, const vk::raii::CommandBuffer& commands);

 private:
  // Of what happened to one buffer or part of an image.
  struct Past {
    Access write;                 // the last; no stages: none in this submission
    Access seen;                  // where that write is visible, or nothing was written
    vk::PipelineStageFlags read;  // since then
  };
  struct Wait {
    vk::PipelineStageFlags from;
    vk::PipelineStageFlags to;
    vk::AccessFlags written;
    vk::AccessFlags wanted;
  };
  static bool must_wait(const Past& past, const Access& access, Wait& wait);
  static void remember(Past& past, const Access& access, bool waited);

  std::map<const BufferState*, Past> buffers_;
  std::map<std::tuple<const ImageState*, int, int>, Past> parts_;  // by mip level and layer
};

// A layout change of its own, outside of every other use.
void move_to(ImageState& image, const ImageParts& parts, vk::ImageLayout wanted,
             const vk::raii::CommandBuffer& commands);

}  // namespace penumbra::gpu
