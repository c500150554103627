#include "bake/block_run.h"

#include <algorithm>
#include <atomic>
#include <exception>
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

class BakeRun {
 public:
  BakeRun(const BakeJob& job, const BakeOptions& options)
      : job_(job), options_(options), finished_(job.blocks) {}

  std::vector<float> all() {
    const unsigned threads = options_.jobs > 0 ? static_cast<unsigned>(options_.jobs)
                                               : std::max(std::thread::hardware_concurrency(), 1U);
    platform::run_on_threads(threads, [this] { work(); });
    if (failure_) std::rethrow_exception(failure_);
    std::vector<float> numbers;
    for (const std::vector<float>& block : finished_)
      numbers.insert(numbers.end(), block.begin(), block.end());
    return numbers;
  }

 private:
  void work() {
    try {
      while (!stopped_) {
        const std::size_t block = next_++;
        if (block >= job_.blocks) return;
        if (options_.cancelled && options_.cancelled()) throw platform::Interrupted();
        finish(block);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stopped_ = true;
    }
  }

  void finish(std::size_t block) {
    std::optional<std::vector<float>> numbers;
    if (options_.store != nullptr) numbers = stored_block(job_, block, *options_.store);
    if (!numbers) {
      numbers = job_.block(block);
      if (options_.store != nullptr) store_block(job_, block, *numbers, *options_.store);
    }
    finished_[block] = *std::move(numbers);
    const std::lock_guard lock(mutex_);
    ++done_;
    if (options_.progress) options_.progress(done_, job_.blocks);
  }

  const BakeJob& job_;
  const BakeOptions& options_;
  std::vector<std::vector<float>> finished_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<float> run_bake(const BakeJob& job, const BakeOptions& options) {
  return BakeRun(job, options).all();
}

void drop_blocks(const BakeJob& job, const platform::CacheStore& store) {
  for (std::size_t block = 0; block < job.blocks; ++block) store.drop(baked_block_kind, key_of(job, block));
}

}  // namespace penumbra::bake
