#include "preparation/repeated_semantics.h"

#include <algorithm>
#include <charconv>

#include "preparation/number_shape.h"
#include "preparation/semantic_names.h"

namespace penumbra::preparation {

// A matrix takes one per column, an array one per element; with an unknown size, only the first is checked.
std::size_t RepeatedSemantics::elements(const SemanticUse& use) const {
  const NumberShape shape = shape_of_type(text_[use.type].spelling);
  std::size_t count = shape.is_matrix() ? static_cast<std::size_t>(shape.columns) : 1;
  for (std::size_t at = use.name + 1; text_.is(at, "[") && text_.is(at + 2, "]"); at += 3) {
    const std::string_view number = text_[at + 1].spelling;
    std::size_t size = 0;
    if (std::from_chars(number.data(), number.data() + number.size(), size).ec != std::errc()) return 1;
    count = std::min<std::size_t>(count * std::max<std::size_t>(size, 1), 64);
  }
  return count;
}

void RepeatedSemantics::add(const SemanticUse& use) {
  const std::string_view word = text_[use.semantic].spelling;
  if (!shape_of_type(text_[use.type].spelling).known()) return;
  const std::size_t digits = word.find_last_not_of("0123456789") + 1;
  std::size_t index = 0;
  std::from_chars(word.data() + digits, word.data() + word.size(), index);
  const std::string name = semantic_key(word);
  for (std::size_t i = 0; i < elements(use); ++i) {
    const auto [known, is_new] =
        uses_.emplace((use.output ? "o" : "i") + name + " " + std::to_string(index + i), use);
    if (is_new) continue;
    const SemanticUse& other = known->second;
    const bool may_share = !use.output && !dxc_ && !name.starts_with("SV_") &&
                           text_[other.type].spelling == text_[use.type].spelling;
    text_.note(use.semantic, may_share ? hlsl::Severity::warning : hlsl::Severity::error,
               "'" + std::string(text_[other.name].spelling) + "' at " + text_.file_of(other.name) + ":" +
                   std::to_string(text_[other.name].line) + " has the semantic '" + std::string(word) +
                   "', too: give each " + (use.output ? "output" : "input") + " its own");
    return;
  }
}

}  // namespace penumbra::preparation
