#include "cli/study_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "study/exits_difference.h"

namespace penumbra::cli {

void tell_notes(const std::vector<std::string>& notes, const Context& context) {
  if (context.quiet) return;
  for (const std::string& note : notes) fmt::print(stderr, "note: {}\n", note);
}

void tell_invalid_results(const std::vector<study::Record>& records, Context& context) {
  for (const study::Record& record : records) {
    const study::Metrics& metrics = record.metrics;
    if (metrics.invalid == 0) continue;
    context.exit_code = findings;
    // Those of the subject with unlimited samples count among the invalid ones, too.
    const std::size_t all = std::max(metrics.pixels * metrics.seeds, metrics.invalid);
    fmt::print(stderr, "{}: {} of {} results are not finite or not in 0..1 (scene {}, light {}°)\n",
               record.technique, metrics.invalid, all, record.scene, record.light_degrees);
  }
}

void tell_differing_exits(const study::Results& results, Context& context) {
  for (const study::ExitsDifference& difference : study::differing_exits(results)) {
    const study::Record& exits = *difference.exits;
    context.exit_code = findings;
    fmt::print(
        stderr,
        "{}: {} {:.4f}, without exits {:.4f} (scene {}, light {}°, device {}): exits must not change the "
        "picture\n  either the technique's exits say less than its filter reads, or the device's driver "
        "compiles them wrongly: use {} there\n",
        exits.technique, difference.figure, difference.with, difference.without, exits.scene,
        exits.light_degrees, exits.device, difference.plain->technique);
  }
}

}  // namespace penumbra::cli
