#include <array>
#include <string>
#include <string_view>
#include <unordered_set>

#include "preparation/source_checks.h"
#include "preparation/value_types.h"

namespace penumbra::preparation {

namespace {

struct Absent {
  std::string_view name;
  std::string_view instead;
};

constexpr std::array absent{
    Absent{"msad4", "write out the sums of absolute differences"},
    Absent{"GetRenderTargetSampleCount", "pass the number in a constant buffer"},
    Absent{"GetRenderTargetSamplePosition", "pass the positions in a constant buffer"},
    Absent{"InterlockedCompareStore", "write it as a statement of its own, or InterlockedCompareExchange()"},
};

}  // namespace

void refuse_absent_intrinsics(TokenText& text) {
  std::unordered_set<std::string_view> own;
  for (const FunctionType& function : text.types().functions()) own.insert(text[function.name].spelling);
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    if (!text.is_identifier(at) || !text.is(at + 1, "(")) continue;
    for (const Absent& function : absent) {
      if (!text.is(at, function.name) || own.contains(function.name)) continue;
      text.note(at, hlsl::Severity::error,
                "'" + std::string(function.name) +
                    "' is HLSL, but is not supported: " + std::string(function.instead));
      text.replace(at, 1, "penumbra_" + std::string(function.name));  // glslang crashes on some of them
    }
  }
  text.apply();
}

}  // namespace penumbra::preparation
