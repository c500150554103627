// The run of a reference: it computes rows in order, each block of them on all threads. It can be cancelled
// and resumed between blocks.
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
  // It is called on the caller's thread after each block of rows; done and total count rays (points of the
  // disc).
  std::function<void(double done, double total)> progress;
  // It is polled often, from any thread. Once it returns true, finished rows are stored and
  // platform::Interrupted is thrown.
  std::function<bool()> cancelled = platform::interrupted;
  double checkpoint_seconds = 2.0;  // a killed process loses at most this much work and one block
};

struct RowJob {
  ImageSize size;
  std::vector<std::uint8_t> valid;                     // pixels without a receiver are skipped
  int samples = 0;                                     // copied into VisibilityImage
  int rays_per_pixel = 0;                              // scale of the progress
  std::string key;                                     // names the answer in the cache
  std::function<HalfCounts(std::size_t pixel)> count;  // reentrant; depends on the pixel alone
};

constexpr int rows_per_block = 8;

// Returns the job's image if the cache has it. The job needs no `count` yet, which takes time to prepare. An
// entry of another size or with other receivers counts as absent: anyone who can write to the cache's folder
// may have put it there.
std::optional<VisibilityImage> kept_image(const RowJob& job, const ReferenceCache* cache);

// Returns the job's image: it is computed from where an earlier run stopped, then stored. `cache` may be
// null. Whatever `count` throws is thrown here.
VisibilityImage run_rows(const RowJob& job, const RunOptions& options, const ReferenceCache* cache);

}  // namespace penumbra::reference
