#include "shaderlab/located_diagnostic.h"

#include <algorithm>

namespace penumbra::shaderlab {

namespace {

constexpr std::size_t kLongestLine = 400;

}  // namespace

hlsl::Diagnostic diagnostic_at(const std::string& file, std::string_view text, const Place& place,
                               hlsl::Severity severity, const std::string& message) {
  const std::size_t begin = place.offset - static_cast<std::size_t>(place.column - 1);
  const std::string_view shown = text.substr(begin, kLongestLine + 1);
  const std::size_t length = std::min(shown.find('\n'), shown.size());
  return {file,     place.line, place.column,
          severity, message,    length > kLongestLine ? std::string() : std::string(shown.substr(0, length))};
}

}  // namespace penumbra::shaderlab
