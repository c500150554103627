#include "platform/worker_frame.h"

#include <cstring>

namespace penumbra::platform {
namespace {

// Both ends are one program on one machine: lengths are in its own byte order.
using Length = std::uint64_t;
constexpr std::size_t head_size = 1 + sizeof(Length);
constexpr Length largest_frame = Length{1} << 32U;

}  // namespace

std::string frame_bytes(FrameKind kind, std::string_view content) {
  std::string bytes(head_size, '\0');
  bytes[0] = static_cast<char>(kind);
  const Length length = content.size();
  std::memcpy(bytes.data() + 1, &length, sizeof length);
  return bytes.append(content);
}

std::optional<Frame> FrameReader::next() {
  if (pending_.size() - at_ < head_size) return std::nullopt;
  Length length = 0;
  std::memcpy(&length, pending_.data() + at_ + 1, sizeof length);
  if (length > largest_frame) return Frame{FrameKind{}, {}};
  if (pending_.size() - at_ - head_size < length) return std::nullopt;
  Frame frame{static_cast<FrameKind>(pending_[at_]), pending_.substr(at_ + head_size, length)};
  at_ += head_size + length;
  if (at_ == pending_.size()) {
    pending_.clear();
    at_ = 0;
  }
  return frame;
}

}  // namespace penumbra::platform
