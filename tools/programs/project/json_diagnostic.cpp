#include "project/json_diagnostic.h"

#include <charconv>
#include <string_view>
#include <utility>

namespace penumbra::project {

namespace {

// Takes ":123" off the end; returns 0 when there is none.
int take_number_behind_colon(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon + 1 == text.size()) return 0;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1) return 0;
  text = text.substr(0, colon);
  return number;
}

}  // namespace

hlsl::Diagnostic diagnostic_at(const std::string& where, hlsl::Severity severity, std::string message) {
  std::string_view file = where;
  const int last = take_number_behind_colon(file);
  const int before = last == 0 ? 0 : take_number_behind_colon(file);
  const int line = before == 0 ? last : before;
  const int column = before == 0 ? 0 : last;
  return {std::string(file), line, column, severity, std::move(message), {}};
}

hlsl::Diagnostic diagnostic_of(const std::filesystem::path& file, hlsl::Severity severity,
                               std::string message) {
  return {file.string(), 0, 0, severity, std::move(message), {}};
}

hlsl::Diagnostic diagnostic_from(const InputError& error, const std::filesystem::path& file,
                                 hlsl::Severity severity) {
  std::string text = error.what();
  const std::size_t remedy = text.find("\n  ");
  if (remedy != std::string::npos) text.replace(remedy, 3, "; ");
  const std::string name = file.string();
  const std::size_t end = text.find(": ", text.compare(0, name.size(), name) == 0 ? name.size() : 0);
  if (end == std::string::npos) return diagnostic_of(file, severity, text);
  return diagnostic_at(text.substr(0, end), severity, text.substr(end + 2));
}

}  // namespace penumbra::project
