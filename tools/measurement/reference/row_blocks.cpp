#include "reference/row_blocks.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <utility>

namespace penumbra::reference {
namespace {

constexpr std::size_t pixels_per_task = 32;

using Clock = std::chrono::steady_clock;

class RowRun {
 public:
  RowRun(const RowJob& job, const RunOptions& options, const ReferenceCache* cache)
      : job_(job),
        options_(options),
        cache_(cache),
        arena_(threads(options.jobs)),
        counts_(job.valid.size()) {}

  std::vector<HalfCounts> finish() {
    resume();
    total_rays_ = rays(0, counts_.size());
    done_rays_ = rays(0, done_);
    report();
    const std::size_t block = static_cast<std::size_t>(job_.size.width) * rows_per_block;
    while (done_ < counts_.size()) {
      const std::size_t end = std::min(done_ + block, counts_.size());
      try {
        compute(done_, end);
      } catch (const platform::Interrupted&) {
        keep_finished_rows();
        throw;
      }
      done_rays_ += rays(done_, end);
      done_ = end;
      report();
      if (std::chrono::duration<double>(Clock::now() - kept_at_).count() >= options_.checkpoint_seconds) {
        keep_finished_rows();
      }
    }
    return std::move(counts_);
  }

 private:
  // More threads than hardware threads would only cause a warning of oneTBB.
  static int threads(int jobs) {
    const int most = tbb::info::default_concurrency();
    return jobs > 0 ? std::min(jobs, most) : most;
  }

  void resume() {
    if (cache_ == nullptr) return;
    const std::vector<HalfCounts> beginning = cache_->find_beginning(job_.key);
    const bool answers = std::all_of(beginning.begin(), beginning.end(), [this](const HalfCounts& counts) {
      return counts.first + counts.second <= job_.samples;
    });
    if (beginning.size() > counts_.size() || !answers) return;
    std::copy(beginning.begin(), beginning.end(), counts_.begin());
    done_ = beginning.size();
  }

  void compute(std::size_t begin, std::size_t end) {
    arena_.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, pixels_per_task),
                        [&](const tbb::blocked_range<std::size_t>& pixels) {
                          if (options_.cancelled && options_.cancelled()) throw platform::Interrupted();
                          for (std::size_t pixel = pixels.begin(); pixel < pixels.end(); ++pixel) {
                            if (job_.valid[pixel] != 0) counts_[pixel] = job_.count(pixel);
                          }
                        });
    });
  }

  double rays(std::size_t begin, std::size_t end) const {
    const auto pixels = std::count(job_.valid.begin() + static_cast<std::ptrdiff_t>(begin),
                                   job_.valid.begin() + static_cast<std::ptrdiff_t>(end), 1);
    return static_cast<double>(pixels) * job_.rays_per_pixel;
  }

  void report() const {
    if (options_.progress) options_.progress(done_rays_, total_rays_);
  }

  void keep_finished_rows() {
    if (cache_ == nullptr || done_ == 0) return;
    cache_->store_beginning(job_.key, std::span(counts_).first(done_));
    kept_at_ = Clock::now();
  }

  const RowJob& job_;
  const RunOptions& options_;
  const ReferenceCache* cache_;
  tbb::task_arena arena_;
  std::vector<HalfCounts> counts_;
  std::size_t done_ = 0;  // pixels, whole rows
  double done_rays_ = 0.0;
  double total_rays_ = 0.0;
  Clock::time_point kept_at_ = Clock::now();
};

}  // namespace

std::optional<VisibilityImage> kept_image(const RowJob& job, const ReferenceCache* cache) {
  std::optional<VisibilityImage> kept = cache == nullptr ? std::nullopt : cache->find(job.key);
  const bool answers = kept && kept->width == job.size.width && kept->height == job.size.height &&
                       kept->samples == job.samples && kept->valid == job.valid;
  return answers ? std::move(kept) : std::nullopt;
}

VisibilityImage run_rows(const RowJob& job, const RunOptions& options, const ReferenceCache* cache) {
  const std::vector<HalfCounts> counts = RowRun(job, options, cache).finish();
  VisibilityImage image = from_half_counts(job.size, counts, job.valid, job.samples);
  if (cache != nullptr) {
    cache->store(job.key, image);
    cache->drop_beginning(job.key);
  }
  return image;
}

}  // namespace penumbra::reference
