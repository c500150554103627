// The protocol between a pool and its workers: frames of a kind, a length and a content. Internal to this
// folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra::platform {

// The worker's descriptor for frames.
inline constexpr int worker_frames_descriptor = 3;

enum class FrameKind : char {
  settings = 's',     // to the worker, first: the limits
  message = 'm',      // to the worker
  reply = 'r',        // to the worker: the answer to its question
  ready = 'h',        // from the worker, first
  question = 'q',     // from the worker, which waits for a reply
  note = 'n',         // from the worker
  answer = 'a',       // from the worker: the message is done
  failure = 'f',      // from the worker: the handler threw
  spent = 'x',        // from the worker: the handler threw a WorkerSpent, and the worker cannot be used again
  environment = 'e',  // from the worker: the handler threw an EnvironmentError
};

struct Frame {
  FrameKind kind = FrameKind::note;
  std::string content;
};

inline constexpr std::size_t frame_head_size = 1 + sizeof(std::uint64_t);

std::array<char, frame_head_size> frame_head(FrameKind kind, std::size_t content_size);
std::string frame_bytes(FrameKind kind, std::string_view content);

// Returns the text of this failure, whichever side detects it first.
std::string too_much_memory(std::size_t limit);

// The reader accepts bytes in any chunks and returns whole frames. Once the bytes are malformed or a frame
// exceeds `largest` bytes, it returns an invalid frame, and nothing after it.
class FrameReader {
 public:
  explicit FrameReader(std::size_t largest) : largest_(largest) {}

  void add(const char* bytes, std::size_t count);
  std::optional<Frame> next();

 private:
  void begin();

  std::size_t largest_;
  std::array<char, frame_head_size> head_{};
  std::size_t head_filled_ = 0;
  std::uint64_t length_ = 0;
  std::string content_;
  std::deque<Frame> whole_;
  bool broken_ = false;
};

}  // namespace penumbra::platform
