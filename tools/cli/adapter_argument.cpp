#include "cli/adapter_argument.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>

#include "cli/option_text.h"
#include "input/input_error.h"

namespace penumbra::cli {
namespace {

constexpr const char* kForm = "--adapter 'NAME=FILE;KEYWORD;UNIFORM=1,2,3;TEXTURE=picture.png'";

// All of a text as finite numbers between commas; nothing when a part of it is none.
std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    double number = 0.0;
    const char* end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    if (part.empty() || error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  if (numbers.empty()) return std::nullopt;
  return numbers;
}

void add_value(resolve::Adapter& adapter, const std::string& name, const std::string& value) {
  const bool known_texture =
      std::any_of(adapter.textures.begin(), adapter.textures.end(),
                  [&](const resolve::AdapterTexture& texture) { return texture.name == name; });
  if (known_texture || adapter.uniforms.count(name) != 0) {
    throw InputError("--adapter " + adapter.name, "'" + name + "' is given twice");
  }
  if (std::optional<std::vector<double>> numbers = numbers_of(value)) {
    adapter.uniforms.emplace(name, *std::move(numbers));
  } else {
    adapter.textures.push_back(resolve::adapter_texture(name, value));
  }
}

}  // namespace

resolve::Adapter parse_adapter(const std::string& text) {
  const std::vector<std::string> parts = split(text, ';');
  if (parts.empty()) throw InputError("--adapter", "is empty", kForm);
  resolve::Adapter adapter;
  std::tie(adapter.name, adapter.file) = name_and_value("--adapter", parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].find('=') == std::string::npos) {
      adapter.keywords.push_back(parts[i]);
      continue;
    }
    const auto [name, value] = name_and_value("--adapter", parts[i]);
    add_value(adapter, name, value);
  }
  return adapter;
}

}  // namespace penumbra::cli
