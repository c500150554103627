#include "cli/adapter_argument.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <tuple>

#include "cli/option_text.h"
#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "parameters/settings_input.h"

namespace penumbra::cli {
namespace {

constexpr const char* kForm = "--adapter 'NAME=FILE;KEYWORD;UNIFORM=1,2,3;TEXTURE=picture.png'";

// Returns all of a text as finite numbers between commas, or nothing when a part of it is no number.
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

void add_value(resolve::Adapter& adapter, const std::string& name, const std::string& value,
               const scene::ReadingProcess& process) {
  const bool known_texture =
      std::any_of(adapter.textures.begin(), adapter.textures.end(),
                  [&](const resolve::AdapterTexture& texture) { return texture.name == name; });
  if (known_texture || adapter.uniforms.count(name) != 0) {
    throw InputError("--adapter " + adapter.name, "'" + name + "' is given twice");
  }
  if (std::optional<std::vector<double>> numbers = numbers_of(value)) {
    adapter.uniforms.emplace(name, *std::move(numbers));
  } else {
    adapter.textures.push_back(resolve::adapter_texture(name, value, process));
  }
}

double bounded(const std::string& name, const std::string& text, double most) {
  const double value = number("--adapter: " + name, text);
  if (value < 0.0 || value > most) {
    throw InputError("", fmt::format("--adapter: {} must be from 0 to {:g}, not {}", name, most, text));
  }
  return value;
}

// "@NAME=VALUE" sets how the adapter's function is run.
void set_adapter_setting(resolve::Adapter& adapter, const std::string& name, const std::string& value) {
  static const std::vector<std::string> kNames{"@depth-bias", "@normal-bias", "@soft-quality",
                                               "@light-scale"};
  if (name == "@depth-bias") {
    adapter.bias.depth = bounded(name, value, 10.0);
  } else if (name == "@normal-bias") {
    adapter.bias.normal = bounded(name, value, 10.0);
  } else if (name == "@soft-quality") {
    adapter.bias.soft_quality = parameters::soft_quality_named(value);
  } else if (name == "@light-scale") {
    adapter.light_scale = bounded(name, value, 10.0);
  } else {
    throw InputError("", "--adapter: unknown setting '" + name + "'", unknown_name_remedy(name, kNames));
  }
}

}  // namespace

resolve::Adapter parse_adapter(const std::string& text, const scene::ReadingProcess& process) {
  const std::vector<std::string> parts = split(text, ';');
  if (parts.empty()) throw InputError("--adapter", "is empty", kForm);
  resolve::Adapter adapter;
  std::tie(adapter.name, adapter.file) = name_and_value("--adapter", parts[0]);
  require_plain_name("--adapter", adapter.name);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].find('=') == std::string::npos) {
      if (!hlsl::is_identifier(parts[i])) {
        throw InputError("--adapter " + adapter.name, "'" + parts[i] + "' is not a keyword's name", kForm);
      }
      adapter.keywords.push_back(parts[i]);
      continue;
    }
    const auto [name, value] = name_and_value("--adapter", parts[i]);
    if (name.starts_with("@"))
      set_adapter_setting(adapter, name, value);
    else
      add_value(adapter, name, value, process);
  }
  return adapter;
}

}  // namespace penumbra::cli
