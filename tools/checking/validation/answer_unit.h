// A worker's processing of one unit: preprocesses its text, and unless the result is cached, compiles it and
// checks every target.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fxc/judge.h"
#include "platform/worker_pool.h"
#include "shaders/compile.h"

namespace penumbra::validation {

// The handler of worker processes and of threads (platform::WorkHandler), for one run: files are read once.
// Several threads may call it at once.
class UnitService {
 public:
  UnitService();
  ~UnitService();

  // Turns an encoded UnitJob into an encoded UnitReply. Errors of shaders are part of the reply. Throws
  // EnvironmentError if a target's driver is missing.
  std::string answer(const std::string& job, platform::WorkerLink& link);

  // Starts FXC for units that it compiles. In a worker it is called before the process is confined; otherwise
  // FXC starts with the first such unit. Throws EnvironmentError when it does not start.
  void start_fxc(const fxc::JudgeLimits& limits);

 private:
  struct Memory;  // the files that it has read, its results, and its FXC

  // There is one for each working thread; they are kept for later threads.
  std::mutex mutex_;
  std::vector<std::unique_ptr<Memory>> free_;
};

}  // namespace penumbra::validation
