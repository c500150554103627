#include <string>

#include "preparation/source_checks.h"

namespace penumbra::preparation {

void check_thread_group(TokenText& text, const EntryPoint& entry) {
  if (entry.stage != hlsl::Stage::compute) return;
  std::size_t name = npos;
  for (const hlsl::Declaration& declaration : text.outline())
    if (declaration.kind == hlsl::Declaration::Kind::function &&
        text[declaration.name].spelling == entry.name)
      name = declaration.name;
  if (name == npos) return;
  for (std::size_t at = name; at > 0 && !text.is(at, ";") && !text.is(at, "}"); --at)
    if (text.is(at, "numthreads")) return;
  text.note(name, hlsl::Severity::error,
            "'" + entry.name + "' has no [numthreads(x, y, z)], which a compute program needs");
}

}  // namespace penumbra::preparation
