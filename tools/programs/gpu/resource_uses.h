// The resources that the steps of a submission read and write, and the barriers that follow from them.
// Internal to this folder.
#pragma once

#include <tuple>

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

// The barriers of one submission, which begins and ends with a full barrier (DeviceState::submit).
class Barriers {
 public:
  // Records the barrier before a step with these uses: earlier writes are made visible, and images change to
  // the wanted layouts. Returns true when there is anything to wait for. Throws std::logic_error when the
  // step itself reads one part of an image that it writes as something else.
  bool before(const ResourceUses& uses, const vk::raii::CommandBuffer& commands);

 private:
  // The earlier uses of one buffer or part of an image.
  struct Past {
    Access write;                 // the last write; no stages if there was none in this submission
    Access seen;                  // the uses for which that write is visible, or there was no write
    vk::PipelineStageFlags read;  // stages that have read it since then
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

// Changes a layout by itself, outside of every other use.
void move_to(ImageState& image, const ImageParts& parts, vk::ImageLayout wanted,
             const vk::raii::CommandBuffer& commands);

}  // namespace penumbra::gpu
