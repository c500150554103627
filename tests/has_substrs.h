// A matcher of text that contains each of the given parts.
#pragma once

#include <gmock/gmock.h>

namespace penumbra {

template <typename... Parts>
auto HasSubstrs(const Parts&... parts) {
  return testing::AllOf(testing::HasSubstr(parts)...);
}

}  // namespace penumbra
