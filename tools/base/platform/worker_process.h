// A worker process from the pool's side: start, send, receive, monitor, end. POSIX; internal to this folder.
#pragma once

#ifndef _WIN32

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "platform/unreadable_process.h"
#include "platform/worker_frame.h"

namespace penumbra::platform {

class WorkerProcess {
 public:
  // Throws EnvironmentError when the system starts no process. `largest_answer` is the largest number of
  // bytes of one frame that it may send.
  WorkerProcess(const std::vector<std::string>& arguments, std::size_t largest_answer);
  ~WorkerProcess();  // ends it, with all processes that it started
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  void send(FrameKind kind,
            std::string_view content);  // never blocks: buffers what the socket does not accept
  bool has_more_to_send() const { return !outbox_.empty(); }
  void send_more();

  // Both read the available bytes, at most some megabytes. read_frames() returns false when the worker has
  // closed its end: it has ended.
  bool read_frames();
  void read_child_output();
  std::optional<Frame> next_frame() { return reader_.next(); }

  int socket() const { return socket_; }
  int child_output() const { return child_output_; }
  const std::string& output_tail() const { return output_tail_; }
  // Returns 0 where the system does not report it.
  std::size_t resident_bytes() const;
  std::size_t threads() const;

  int end();  // kills it if it is alive; returns its wait status

 private:
  std::string fact(const char* file) const;  // the beginning of a file of /proc; empty where there is none

  UnreadableProcess unreadable_;
  pid_t process_ = 0;
  int socket_ = -1;
  int child_output_ = -1;  // the reading end of its standard output and standard error
  std::string outbox_;
  FrameReader reader_;
  std::string output_tail_;
  std::optional<int> status_;
};

}  // namespace penumbra::platform

#endif
