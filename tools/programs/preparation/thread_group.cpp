#include <string>
#include <vector>

#include "preparation/entry_functions.h"
#include "preparation/list_elements.h"
#include "preparation/source_checks.h"

namespace penumbra::preparation {

namespace {

void check_sizes(TokenText& text, std::size_t attribute) {
  if (!text.is(attribute + 1, "(") || text.matching_bracket(attribute + 1) == npos) return;
  const std::size_t count = list_elements(text, attribute + 1).size();
  if (count != 3)
    text.note(attribute, hlsl::Severity::error,
              "[numthreads(x, y, z)] has three sizes, and " + std::to_string(count) +
                  (count == 1 ? " is" : " are") + " given: write 1 for those that are not used");
}

}  // namespace

void check_thread_group(TokenText& text, const EntryPoint& entry) {
  if (entry.stage != hlsl::Stage::compute) return;
  const std::vector<const hlsl::Declaration*> kernels = entry_functions(text, entry);
  if (kernels.empty()) return;
  const std::size_t name = kernels.back()->name;
  for (std::size_t at = name; at > 0 && !text.is(at, ";") && !text.is(at, "}"); --at)
    if (text.is(at, "numthreads")) return check_sizes(text, at);
  text.note(name, hlsl::Severity::error,
            "'" + entry.name + "' has no [numthreads(x, y, z)], which a compute program needs");
}

}  // namespace penumbra::preparation
