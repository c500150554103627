#include <string>
#include <vector>

#include "preparation/entry_functions.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

void check_thread_group(TokenText& text, const EntryPoint& entry) {
  if (entry.stage != hlsl::Stage::compute) return;
  const std::vector<const hlsl::Declaration*> kernels = entry_functions(text, entry);
  if (kernels.empty()) return;
  const std::size_t name = kernels.back()->name;
  for (std::size_t at = name; at > 0 && !text.is(at, ";") && !text.is(at, "}"); --at)
    if (text.is(at, "numthreads")) return;
  text.note(name, hlsl::Severity::error,
            "'" + entry.name + "' has no [numthreads(x, y, z)], which a compute program needs");
}

}  // namespace penumbra::preparation
