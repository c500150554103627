// A worker's processing of one unit: preprocesses its text, and unless the result is cached, compiles it and
// checks every target.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

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

 private:
  struct Memory;  // of what it has read and compiled

  // One for each working thread; kept for later threads.
  std::mutex mutex_;
  std::vector<std::unique_ptr<Memory>> free_;
};

}  // namespace penumbra::validation
