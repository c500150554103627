#include "cli/option_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "input/input_error.h"

namespace penumbra::cli {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::pair<std::string, std::string> name_and_value(const std::string& option, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw InputError("", option + " '" + text + "' is not of the form NAME=VALUE");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

double number(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) {
    throw InputError("", option + ": '" + text + "' is not a number");
  }
  return value;
}

std::string shell_word(const std::string& text) {
  if (!text.empty() && text.find_first_of(" \t\n;&|<>()$`\"'\\*?[]#~!{}") == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

void require_plain_name(const std::string& option, const std::string& text) {
  std::string shown;
  bool control = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = byte < 0x20 || byte == 0x7F;
    control = control || is_control;
    shown += is_control ? fmt::format("\\x{:02X}", byte) : std::string(1, c);
  }
  if (control) throw InputError("", option + ": the name '" + shown + "' holds a control character");
  for (const char* mark : {"<!--", "-->"}) {
    if (text.find(mark) == std::string::npos) continue;
    throw InputError("", option + ": the name '" + shown + "' holds '" + mark + "'",
                     "Markdown files mark comments with it; names are written into them");
  }
}

}  // namespace penumbra::cli
