#include "bake/block_run.h"

#include <optional>

#include "platform/byte_stream.h"

namespace penumbra::bake {
namespace {

constexpr const char* kBakeKind = "bake";

std::optional<std::vector<float>> kept_bake(const BakeJob& job, const platform::CacheStore* store) {
  const auto entry = store == nullptr ? std::nullopt : store->find(kBakeKind, job.key);
  if (!entry) return std::nullopt;
  platform::ByteReader reader(*entry);
  std::vector<float> numbers = reader.values<float>();
  if (!reader.exhausted()) return std::nullopt;
  return numbers;
}

}  // namespace

std::vector<float> run_bake(const BakeJob& job, const BakeOptions& options) {
  if (std::optional<std::vector<float>> kept = kept_bake(job, options.store)) return *std::move(kept);
  std::vector<std::vector<float>> finished(static_cast<std::size_t>(job.blocks));
  reference::for_each_row(job.blocks, options,
                          [&](int block) { finished[static_cast<std::size_t>(block)] = job.block(block); });
  std::vector<float> numbers;
  for (const std::vector<float>& block : finished) numbers.insert(numbers.end(), block.begin(), block.end());
  if (options.store != nullptr) {
    platform::ByteWriter writer;
    writer.values(numbers);
    options.store->store(kBakeKind, job.key, writer.take());
  }
  return numbers;
}

}  // namespace penumbra::bake
