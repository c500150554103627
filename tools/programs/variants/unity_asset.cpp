#include "variants/unity_asset.h"

#include <algorithm>
#include <charconv>

#include "input/input_error.h"

namespace penumbra::variants {
namespace {

AssetField field_of(std::string_view line, int number) {
  AssetField field;
  field.line = number;
  line = line.substr(0, line.find_last_not_of(" \r") + 1);
  field.indent = std::min(line.find_first_not_of(' '), line.size());
  if (line.substr(field.indent).starts_with("- ")) {
    field.begins_item = true;
    field.indent += 2;
  }
  line.remove_prefix(field.indent);
  const std::size_t colon = line.find(':');
  const bool named = colon != std::string_view::npos &&
                     (colon + 1 == line.size() || line[colon + 1] == ' ') && !line.starts_with('{');
  field.name = named ? line.substr(0, colon) : std::string_view{};
  field.value = !named ? line : line.substr(std::min(colon + 2, line.size()));
  return field;
}

}  // namespace

std::vector<AssetField> asset_fields(std::string_view text, const std::string& file) {
  if (text.find('\0') != std::string_view::npos)
    throw InputError(file, "is a binary asset",
                     "set Project Settings > Editor > Asset Serialization to Force Text");
  std::vector<AssetField> fields;
  int number = 1;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    fields.push_back(field_of(text.substr(at, end - at), number));
    at = end + 1;
  }
  return fields;
}

int number_in(const AssetField& field, int highest, const std::string& file) {
  int value = -1;
  const char* const end = field.value.data() + field.value.size();
  const auto [stop, error] = std::from_chars(field.value.data(), end, value);
  if (error != std::errc() || stop != end || value < 0 || value > highest)
    throw InputError(file + ":" + std::to_string(field.line),
                     "'" + std::string(field.name) + "' must be an integer from 0 to " +
                         std::to_string(highest) + ", found '" + std::string(field.value) + "'");
  return value;
}

std::string guid_in(std::string_view value) {
  constexpr std::string_view name = "guid: ";
  const std::size_t at = value.find(name);
  if (at == std::string_view::npos) return {};
  value.remove_prefix(at + name.size());
  return std::string(value.substr(0, value.find_first_of(",} \r\n")));
}

}  // namespace penumbra::variants
