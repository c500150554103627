// The kinds of cache entries of validation (platform/cache_store.h).
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "platform/cache_store.h"

namespace penumbra::validation {

enum class EntryKind {
  sources,  // the files that a text consists of, and its key (source_record.h)
  compile,  // a CompileAnswer
  emitted,  // an EmittedAnswer
};

inline constexpr std::array<std::string_view, 3> entry_kinds{"sources", "compile", "emitted"};

constexpr std::string_view name_of(EntryKind kind) {
  return entry_kinds[static_cast<std::size_t>(kind)];
}

}  // namespace penumbra::validation
