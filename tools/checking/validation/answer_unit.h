// What a worker does with one unit: makes its text, and unless the answer is known, compiles it and tries
// every target.
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

  // An encoded UnitJob to an encoded UnitReply. Bad shaders are in the reply. Throws EnvironmentError when a
  // target's driver is not there.
  std::string answer(const std::string& job, platform::WorkerLink& link);

 private:
  struct Memory;  // of what it has read and compiled

  // One for each thread that is at work; they stay for those that come after.
  std::mutex mutex_;
  std::vector<std::unique_ptr<Memory>> free_;
};

}  // namespace penumbra::validation
