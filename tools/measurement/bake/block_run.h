// A bake's run: it computes blocks of numbers on all threads, and stores them once all are done, so that the
// same bake is then only read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "platform/cache_store.h"
#include "reference/row_blocks.h"

namespace penumbra::bake {

struct BakeOptions : reference::RunOptions {    // progress counts blocks
  const platform::CacheStore* store = nullptr;  // keeps finished bakes; may be null
};

struct BakeJob {
  std::string key;  // hash of everything that the blocks depend on
  int blocks = 0;
  std::function<std::vector<float>(int block)> block;  // reentrant
};

// Returns all blocks, one after the other. Throws platform::Interrupted when cancelled, and whatever the
// job's function throws; then nothing is stored.
std::vector<float> run_bake(const BakeJob& job, const BakeOptions& options);

}  // namespace penumbra::bake
