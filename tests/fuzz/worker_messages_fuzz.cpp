// Reads messages between a run and its workers: frames (the first byte cuts them) and what they hold.
#include <algorithm>
#include <stdexcept>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "platform/worker_answer.h"
#include "platform/worker_frame.h"
#include "scene/scene_message.h"
#include "validation/source_record.h"
#include "validation/unit_message.h"

namespace penumbra::fuzz {

namespace {
using validation::encode;  // also for a list of lists of messages

constexpr std::size_t largest = 1 << 16;

std::string frames_of(std::string_view bytes, std::size_t piece) {
  platform::FrameReader reader(largest);
  std::string all;
  while (!bytes.empty()) {
    const std::size_t count = std::min(piece, bytes.size());
    reader.add(bytes.data(), count);
    bytes.remove_prefix(count);
    while (const std::optional<platform::Frame> frame = reader.next()) {
      require(frame->content.size() <= largest, "no frame is larger than it may be");
      all += platform::frame_bytes(frame->kind, frame->content);
    }
  }
  return all;
}

// A message that is decoded and encoded stays what it is.
template <typename Decode>
void decode(std::string_view bytes, const Decode& decodes) {
  const auto value = decodes(bytes);
  if (!value) return;
  const std::string written = encode(*value);
  const auto again = decodes(written);
  require(again.has_value() && encode(*again) == written, "a message reads as it was written");
}

// Bytes that are no answer at all are std::invalid_argument.
template <typename Reads>
void read_answer(const Reads& reads) {
  read([&] {
    try {
      reads();
    } catch (const std::invalid_argument&) {
    }
  });
}

void require_whole(const scene::Texture& texture) {
  require(texture.rgba.size() == std::size_t{4} * texture.width * texture.height, "every pixel is there");
}

void require_whole(const scene::Scene& scene) {
  for (const scene::Texture& texture : scene.textures) require_whole(texture);
  for (const std::uint32_t index : scene.mesh.indices)
    require(index < scene.mesh.positions.size(), "a triangle has its vertices");
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i)
    require(scene.mesh.material_of(i) < scene.materials.size(), "a triangle has its material");
  require(scene::encode(scene::decode_scene(scene::encode(scene))) == scene::encode(scene),
          "a scene reads as it was written");
}

}  // namespace

void targets::worker_messages(std::string_view bytes) {
  const std::size_t piece = std::size_t{1} + take_byte(bytes);
  require(frames_of(bytes, piece) == frames_of(bytes, largest), "frames do not depend on how they arrive");
  decode(bytes, validation::decode_job);
  decode(bytes, validation::decode_reply);
  decode(bytes, validation::decode_unit);
  decode(bytes, validation::decode_compile_answer);
  decode(bytes, validation::decode_emitted_answer);
  decode(bytes, validation::decode_source_record);
  read_answer([&] { platform::taken_answer(std::string(bytes)); });
  read_answer([&] { require_whole(scene::decode_texture(bytes)); });
  read_answer([&] { require_whole(scene::decode_scene(bytes)); });
}

}  // namespace penumbra::fuzz
