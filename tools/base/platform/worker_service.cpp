#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <new>

#include "input/input_error.h"
#include "platform/confinement.h"
#include "platform/unreadable_process.h"
#include "platform/worker_frame.h"
#include "platform/worker_pool.h"

#ifndef _WIN32
#include <dlfcn.h>
#include <sys/socket.h>
#include <unistd.h>
#ifdef __linux__
#include <malloc.h>
#include <sys/prctl.h>
#endif
#include <cerrno>
#include <csignal>
#endif

namespace penumbra::platform {

#ifndef _WIN32
namespace {

// The link exits immediately and silently if the parent has ended, because no process is left to receive a
// message.
class ParentLink final : public WorkerLink {
 public:
  std::string ask(std::string_view question) override {
    write(FrameKind::question, question);
    return read().content;
  }
  void note(std::string_view text) override { write(FrameKind::note, text); }

  void write(FrameKind kind, std::string_view content) const {
    constexpr std::size_t small = 65536;
    if (content.size() <= small) return write_bytes(frame_bytes(kind, content));
    const auto head = frame_head(kind, content.size());
    write_bytes({head.data(), head.size()});
    write_bytes(content);
  }

  Frame read() {
    char buffer[65536];
    for (;;) {
      if (std::optional<Frame> frame = reader_.next()) return *std::move(frame);
      const ssize_t count = ::read(worker_frames_descriptor, buffer, sizeof buffer);
      if (count > 0)
        reader_.add(buffer, static_cast<std::size_t>(count));
      else if (count == 0 || errno != EINTR)
        ::_exit(EXIT_SUCCESS);
    }
  }

  static void write_bytes(std::string_view bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t count = ::write(worker_frames_descriptor, bytes.data() + at, bytes.size() - at);
      if (count > 0)
        at += static_cast<std::size_t>(count);
      else if (errno != EINTR)
        ::_exit(EXIT_SUCCESS);
    }
  }

 private:
  FrameReader reader_{std::numeric_limits<std::size_t>::max()};  // the parent is trusted
};

void bind_to_parent() {
#ifdef __linux__
  // If the parent has already ended, the first read reports it.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  std::signal(SIGPIPE, SIG_IGN);  // NOLINT(cert-err33-c): a closed socket is detected when it is written to
}

// Compilers take and return the same memory for every message. Giving it back to the system in between, and
// clearing it anew, would cost several per cent of their time.
void keep_memory() {
#ifdef __GLIBC__
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
  ::mallopt(M_TOP_PAD, 16 << 20);
  ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

// Reads the parent's first frame.
WorkerLimits read_limits(ParentLink& link) {
  const Frame frame = link.read();
  WorkerLimits limits;
  unsigned long long processor_seconds = 0;
  if (frame.kind != FrameKind::settings ||
      std::sscanf(frame.content.c_str(), "%llu %zu %zu", &processor_seconds, &limits.memory,
                  &limits.answer) != 3)
    ::_exit(EXIT_FAILURE);
  limits.processor_time = std::chrono::seconds(processor_seconds);
  return limits;
}

// A worker sends this when the system has no more memory. Allocators written in C end the process, and others
// throw an exception that may be thrown in a library's destructor, so it waits for neither.
std::string out_of_memory;  // the frame, prepared while there is memory

void end_without_memory() {
  ParentLink::write_bytes(out_of_memory);
  ::_exit(EXIT_FAILURE);
}

void end_when_out_of_memory() {
  std::set_new_handler(end_without_memory);
  // mimalloc, where the program runs on it (PenumbraTarget.cmake), calls no new handler but one of its own.
  using OnError = void(int error, void* argument);
  using Register = void(OnError * handler, void* argument);
  if (void* found = ::dlsym(RTLD_DEFAULT, "mi_register_error"))
    reinterpret_cast<Register*>(found)(
        [](int error, void*) {
          if (error == ENOMEM || error == EOVERFLOW) end_without_memory();
        },
        nullptr);
}

void handle(const WorkHandler& handler, const std::string& message, const WorkerLimits& limits,
            ParentLink& link) {
  try {
    const std::string answer = handler(message, link);
    if (answer.size() > limits.answer)
      link.write(FrameKind::failure,
                 "sent a response of more than " + std::to_string(limits.answer >> 20U) + " MiB");
    else
      link.write(FrameKind::answer, answer);
  } catch (const EnvironmentError& error) {
    link.write(FrameKind::environment, error.what());
  } catch (const WorkerSpent& error) {
    link.write(FrameKind::spent, error.what());
  } catch (const std::bad_alloc&) {
    link.write(FrameKind::failure, too_much_memory(limits.memory));
  } catch (const std::exception& error) {
    link.write(FrameKind::failure, std::string("failed: ") + error.what());
  }
}

void serve(const WorkHandler& handler, const std::function<void(const WorkerLimits&)>& prepare,
           ParentLink& link) {
  const WorkerLimits limits = read_limits(link);
  out_of_memory = frame_bytes(FrameKind::failure, too_much_memory(limits.memory));
  end_when_out_of_memory();
  try {
    if (prepare) prepare(limits);
    confine_process(limits.memory);
  } catch (const EnvironmentError& error) {
    return link.write(FrameKind::environment, error.what());
  }
  link.write(FrameKind::ready, {});
  for (;;) {
    const Frame frame = link.read();
    if (frame.kind != FrameKind::message) continue;
    limit_processor_time(static_cast<unsigned long long>(limits.processor_time.count()));
    handle(handler, frame.content, limits, link);
  }
}

}  // namespace

int serve_worker(const WorkHandler& handler, const std::function<void(const WorkerLimits&)>& prepare) {
  close_descriptors_from(worker_frames_descriptor + 1);
  give_up_reading_processes();  // done before a driver starts threads, which would keep the right
  bind_to_parent();
  keep_memory();
  ParentLink link;
  serve(handler, prepare, link);
  return EXIT_FAILURE;
}

#else

int serve_worker(const WorkHandler&, const std::function<void(const WorkerLimits&)>&) {
  throw EnvironmentError("worker processes are supported on POSIX systems only");
}

#endif

}  // namespace penumbra::platform
