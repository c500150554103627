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

// The handler of worker processes and of threads (platform::WorkHandler). For one run: files are read once.
// May be called by several threads at once.
class UnitService {
 public:
  UnitService();
  ~UnitService();

  // An encoded UnitJob to an encoded UnitReply. Errors of shaders are part of the reply. Throws
  // EnvironmentError if a target's driver is missing.
  std::string answer(const std::string& job, platform::WorkerLink& link);

  // For units that FXC compiles. In a worker it is called before the process is confined; otherwise FXC
  // starts with the first such unit. Throws EnvironmentError when it does not start.
  void start_fxc(const fxc::JudgeLimits& limits);

 private:
  struct Memory;  // of what it has read and compiled, and its FXC

  // One for each working thread; kept for later threads.
  std::mutex mutex_;
  std::vector<std::unique_ptr<Memory>> free_;
};

}  // namespace penumbra::validation
