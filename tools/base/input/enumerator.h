// Enumerators by their names, which stand in an array in the order of the enumerators.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace penumbra {

template <typename Value, std::size_t count>
std::optional<Value> enumerator_named(std::string_view name, const std::array<const char*, count>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Value>(found - names.begin()));
}

}  // namespace penumbra
