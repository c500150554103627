#include "bake/block_run.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>

#include "platform/byte_stream.h"
#include "platform/content_hash.h"
#include "platform/thread_group.h"

namespace penumbra::bake {
namespace {

std::string key_of(const BakeJob& job, std::size_t block) {
  platform::ContentHash hash;
  hash.update(std::string_view(job.key)).update(static_cast<std::uint64_t>(block));
  return hash.hex();
}

std::optional<std::vector<float>> stored_block(const BakeJob& job, std::size_t block,
                                               const platform::CacheStore& store) {
  const std::optional<std::string> entry = store.find(baked_block_kind, key_of(job, block));
  if (!entry) return std::nullopt;
  platform::ByteReader reader(*entry);
  std::vector<float> numbers = reader.values<float>();
  if (!reader.exhausted()) return std::nullopt;
  return numbers;
}

void store_block(const BakeJob& job, std::size_t block, const std::vector<float>& numbers,
                 const platform::CacheStore& store) {
  platform::ByteWriter writer;
  writer.values(numbers);
  store.store(baked_block_kind, key_of(job, block), writer.take());
}

}  // namespace

std::vector<float> run_bake(const BakeJob& job, const BakeOptions& options) {
  const unsigned threads = options.jobs > 0 ? static_cast<unsigned>(options.jobs)
                                            : std::max(std::thread::hardware_concurrency(), 1U);
  std::vector<std::vector<float>> finished(job.blocks);
  std::mutex mutex;
  std::size_t done = 0;
  platform::run_all(job.blocks, threads, [&](std::size_t block) {
    if (options.cancelled && options.cancelled()) throw platform::Interrupted();
    std::optional<std::vector<float>> numbers;
    if (options.store != nullptr) numbers = stored_block(job, block, *options.store);
    if (!numbers) {
      numbers = job.block(block);
      if (options.store != nullptr) store_block(job, block, *numbers, *options.store);
    }
    finished[block] = *std::move(numbers);
    const std::lock_guard lock(mutex);
    ++done;
    if (options.progress) options.progress(done, job.blocks);
  });
  std::vector<float> numbers;
  for (const std::vector<float>& block : finished) numbers.insert(numbers.end(), block.begin(), block.end());
  return numbers;
}

void drop_blocks(const BakeJob& job, const platform::CacheStore& store) {
  for (std::size_t block = 0; block < job.blocks; ++block) store.drop(baked_block_kind, key_of(job, block));
}

}  // namespace penumbra::bake
