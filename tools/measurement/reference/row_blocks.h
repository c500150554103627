// The run of a reference: its rows on all threads. One that is cancelled keeps nothing.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "platform/interrupt.h"
#include "reference/reference_cache.h"
#include "reference/visibility_image.h"

namespace penumbra::reference {

struct RunOptions {
  int jobs = 0;  // threads; 0 takes all. The result does not depend on it.
  // It is called before the first row and after each, from any thread, one call at a time. The unit is that
  // of what runs: rays (points of the disc) of a reference, where each row counts the same.
  std::function<void(double done, double total)> progress;
  // It is polled often, from any thread. Once it returns true, platform::Interrupted is thrown.
  std::function<bool()> cancelled = platform::interrupted;

  void throw_if_cancelled() const {
    if (cancelled && cancelled()) throw platform::Interrupted();
  }
};

// Calls row(0) .. row(rows - 1), each once, in any order and from several threads; progress counts rows.
// Throws platform::Interrupted when cancelled, and whatever row throws.
void for_each_row(int rows, const RunOptions& run, const std::function<void(int)>& row);

struct RowJob {
  ImageSize size;
  std::vector<std::uint8_t> valid;                     // pixels without a receiver are skipped
  int samples = 0;                                     // copied into VisibilityImage
  int rays_per_pixel = 0;                              // scale of the progress
  std::string key;                                     // names the answer in the cache
  std::function<HalfCounts(std::size_t pixel)> count;  // reentrant; depends on the pixel alone
};

// Returns the job's image if the cache has it. The job needs no `count` yet, which takes time to prepare. An
// entry of another size or with other receivers counts as absent: anyone who can write to the cache's folder
// may have put it there.
std::optional<VisibilityImage> kept_image(const RowJob& job, const ReferenceCache* cache);

// Returns the job's image, and stores it once it is whole. `cache` may be null. Throws as for_each_row().
VisibilityImage run_rows(const RowJob& job, const RunOptions& options, const ReferenceCache* cache);

}  // namespace penumbra::reference
