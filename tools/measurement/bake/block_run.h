// A bake's run: it computes blocks of numbers on all threads and stores each one when it is done, so that an
// interrupted bake continues where it stopped.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "platform/cache_store.h"
#include "platform/interrupt.h"

namespace penumbra::bake {

struct BakeOptions {
  int jobs = 0;  // threads; 0 takes all. The result does not depend on it.
  // It is called from any thread, one call at a time, after each block.
  std::function<void(std::size_t done, std::size_t total)> progress;
  // It is polled from any thread before each block.
  std::function<bool()> cancelled = platform::interrupted;
  const platform::CacheStore* store = nullptr;  // keeps finished blocks; may be null
};

struct BakeJob {
  std::string key;  // hash of everything that the blocks depend on, but for their number
  std::size_t blocks = 0;
  std::function<std::vector<float>(std::size_t block)> block;  // reentrant
};

inline constexpr const char* baked_block_kind = "bakedblock";  // the kind of the store's entries

// Returns all blocks, one after the other. Throws platform::Interrupted when cancelled, with the finished
// blocks stored, and whatever the job's function throws.
std::vector<float> run_bake(const BakeJob& job, const BakeOptions& options);

// Removes the job's blocks from the store, once its result is written.
void drop_blocks(const BakeJob& job, const platform::CacheStore& store);

}  // namespace penumbra::bake
