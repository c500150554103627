// Runs a reference: rows in order, each block of them on all threads; can be cancelled and resumed between
// blocks.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "platform/interrupt.h"
#include "reference/reference_cache.h"
#include "reference/visibility_image.h"

namespace penumbra::reference {

struct RunOptions {
  int jobs = 0;  // threads; 0 takes all. The result does not depend on it.
  // Called on the caller's thread after each block of rows; done and total in rays (points of the disc).
  std::function<void(double done, double total)> progress;
  // Polled frequently, from any thread; once true, finished rows are stored and platform::Interrupted is
  // thrown.
  std::function<bool()> cancelled = platform::interrupted;
  double checkpoint_seconds = 2.0;  // a killed process loses at most this much work and one block
};

struct RowJob {
  ImageSize size;
  std::vector<std::uint8_t> valid;                     // pixels without a receiver are skipped
  int samples = 0;                                     // into VisibilityImage
  int rays_per_pixel = 0;                              // for progress
  std::string key;                                     // names the answer in the cache
  std::function<HalfCounts(std::size_t pixel)> count;  // reentrant; depends on the pixel alone
};

constexpr int rows_per_block = 8;

// The job's image if it is kept; the job needs no `count` yet, which takes time to prepare. What does not
// answer the job, of another size or other receivers, is nothing: whoever can write the cache's folder can
// put it there.
std::optional<VisibilityImage> kept_image(const RowJob& job, const ReferenceCache* cache);

// The job's image, computed from where an earlier run stopped, then stored. cache may be null. Whatever count
// throws is thrown here.
VisibilityImage run_rows(const RowJob& job, const RunOptions& options, const ReferenceCache* cache);

}  // namespace penumbra::reference
