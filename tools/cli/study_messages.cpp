#include "cli/study_messages.h"

#include <fmt/format.h>

#include <algorithm>

namespace penumbra::cli {

void tell_notes(const std::vector<std::string>& notes, const Context& context) {
  if (context.quiet) return;
  for (const std::string& note : notes) say("note: {}\n", note);
}

void tell_invalid_results(const std::vector<study::Record>& records, Context& context) {
  for (const study::Record& record : records) {
    const study::Metrics& metrics = record.metrics;
    if (metrics.invalid == 0) continue;
    context.exit_code = findings;
    // Invalid values of the subject with unlimited samples count, too, so there may be more than pixels.
    const std::size_t all = std::max(metrics.pixels * metrics.seeds, metrics.invalid);
    say("{}: {} of {} results are not finite or not in 0..1 (scene {}, light {}°)\n", record.technique,
        metrics.invalid, all, record.scene, record.light_degrees);
  }
}

}  // namespace penumbra::cli
