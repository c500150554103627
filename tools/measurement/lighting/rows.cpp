#include "lighting/rows.h"

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace penumbra::lighting {

void for_each_row(int height, const reference::RunOptions& run, const std::function<void(int)>& row) {
  constexpr int kRowsPerReport = 32;
  const int most = tbb::info::default_concurrency();
  tbb::task_arena arena(run.jobs > 0 ? std::min(run.jobs, most) : most);
  for (int begin = 0; begin < height; begin += kRowsPerReport) {
    const int end = std::min(begin + kRowsPerReport, height);
    if (run.progress) run.progress(begin, height);
    arena.execute([&] {
      tbb::parallel_for(begin, end, [&](int i) {
        if (run.cancelled && run.cancelled()) throw platform::Interrupted();
        row(i);
      });
    });
  }
  if (run.progress) run.progress(height, height);
}

}  // namespace penumbra::lighting
