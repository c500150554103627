#include "reference/row_blocks.h"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>

#include "platform/thread_group.h"

namespace penumbra::reference {

void for_each_row(int rows, const RunOptions& run, const std::function<void(int)>& row) {
  std::mutex mutex;
  int done = 0;
  if (run.progress) run.progress(0, rows);
  platform::run_all(static_cast<std::size_t>(rows), run.jobs, [&](std::size_t i) {
    run.throw_if_cancelled();
    row(static_cast<int>(i));
    const std::lock_guard lock(mutex);
    ++done;
    if (run.progress) run.progress(done, rows);
  });
}

std::optional<VisibilityImage> kept_image(const RowJob& job, const ReferenceCache* cache) {
  std::optional<VisibilityImage> kept = cache == nullptr ? std::nullopt : cache->find(job.key);
  const bool answers = kept && kept->width == job.size.width && kept->height == job.size.height &&
                       kept->samples == job.samples && kept->valid == job.valid;
  return answers ? std::move(kept) : std::nullopt;
}

VisibilityImage run_rows(const RowJob& job, const RunOptions& options, const ReferenceCache* cache) {
  constexpr std::size_t kPixelsPerPoll = 32;
  std::vector<HalfCounts> counts(job.valid.size());
  RunOptions run = options;
  if (options.progress) {
    const auto pixels = static_cast<double>(std::count(job.valid.begin(), job.valid.end(), 1));
    run.progress = [&, rays = pixels * job.rays_per_pixel](double done, double total) {
      options.progress(rays * (done / total), rays);
    };
  }
  const auto width = static_cast<std::size_t>(job.size.width);
  for_each_row(job.size.height, run, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * width;
    for (std::size_t pixel = begin; pixel < begin + width; ++pixel) {
      if (pixel % kPixelsPerPoll == 0) run.throw_if_cancelled();
      if (job.valid[pixel] != 0) counts[pixel] = job.count(pixel);
    }
  });
  VisibilityImage image = from_half_counts(job.size, counts, job.valid, job.samples);
  if (cache != nullptr) cache->store(job.key, image);
  return image;
}

}  // namespace penumbra::reference
