#include "platform/worker_frame.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace penumbra::platform {

// Lengths are in the machine's own byte order, because both ends are one program on one machine.
std::array<char, frame_head_size> frame_head(FrameKind kind, std::size_t content_size) {
  std::array<char, frame_head_size> head{static_cast<char>(kind)};
  const std::uint64_t length = content_size;
  std::memcpy(head.data() + 1, &length, sizeof length);
  return head;
}

std::string frame_bytes(FrameKind kind, std::string_view content) {
  const auto head = frame_head(kind, content.size());
  std::string bytes;
  bytes.reserve(head.size() + content.size());
  return bytes.append(head.data(), head.size()).append(content);
}

std::string too_much_memory(std::size_t limit) {
  return "took more than " + std::to_string(limit >> 20U) + " MiB of memory";
}

void FrameReader::add(const char* bytes, std::size_t count) {
  while (count > 0 && !broken_) {
    const bool in_head = head_filled_ < head_.size();
    const std::size_t wanted = in_head ? head_.size() - head_filled_ : length_ - content_.size();
    const std::size_t taken = std::min(count, wanted);
    if (in_head) {
      std::memcpy(head_.data() + head_filled_, bytes, taken);
      head_filled_ += taken;
      if (head_filled_ == head_.size()) begin();
    } else {
      content_.append(bytes, taken);
    }
    if (!broken_ && head_filled_ == head_.size() && content_.size() == length_) {
      whole_.push_back({static_cast<FrameKind>(head_[0]), std::exchange(content_, {})});
      head_filled_ = 0;
    }
    bytes += taken;
    count -= taken;
  }
}

void FrameReader::begin() {
  std::memcpy(&length_, head_.data() + 1, sizeof length_);
  broken_ = length_ > largest_;
  if (broken_)
    whole_.push_back({FrameKind{}, {}});
  else
    content_.reserve(length_);
}

std::optional<Frame> FrameReader::next() {
  if (whole_.empty()) return std::nullopt;
  Frame frame = std::move(whole_.front());
  whole_.pop_front();
  return frame;
}

}  // namespace penumbra::platform
