// How a pool and its workers talk: frames of a kind, a length and a content. Internal to this room.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra::platform {

// The worker's descriptor for frames.
inline constexpr int worker_frames_descriptor = 3;

enum class FrameKind : char {
  settings = 's',     // to the worker, first: seconds of processor time for each message
  message = 'm',      // to the worker
  reply = 'r',        // to the worker: the answer to its question
  ready = 'h',        // from the worker, first
  question = 'q',     // from the worker, which waits for a reply
  note = 'n',         // from the worker
  answer = 'a',       // from the worker: the message is done
  failure = 'f',      // from the worker: the handler threw
  environment = 'e',  // from the worker: the handler threw an EnvironmentError
};

struct Frame {
  FrameKind kind = FrameKind::note;
  std::string content;
};

std::string frame_bytes(FrameKind kind, std::string_view content);

// Takes bytes as they come and gives whole frames; one of no kind once they cannot be frames.
class FrameReader {
 public:
  void add(const char* bytes, std::size_t count) { pending_.append(bytes, count); }
  std::optional<Frame> next();

 private:
  std::string pending_;
  std::size_t at_ = 0;  // what stands before has been given
};

}  // namespace penumbra::platform
