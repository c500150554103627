#include "study/html_text.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "input/text_line.h"

namespace penumbra::study {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

void append_ascii(std::string& html, char c) {
  switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    case '\'':
      html += "&#39;";
      break;
    default:
      if ((c < 32 && c != '\t' && c != '\n') || c == 127) {
        html += kReplacement;
      } else {
        html += c;
      }
  }
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const TextCharacter character = character_at(text, 0);
    if (character.is_valid && character.bytes == 1) {
      append_ascii(html, text.front());
    } else {
      html += character.is_valid ? text.substr(0, character.bytes) : kReplacement;
    }
    text.remove_prefix(character.bytes);
  }
  return html;
}

std::string command_html(std::string_view command) {
  std::string words;
  while (!command.empty()) {
    const std::size_t end = std::min(command.find(' '), command.size());
    if (end > 0) words += "<span>" + escape_html(command.substr(0, end)) + "</span>";
    if (end < command.size()) words += ' ';
    command.remove_prefix(std::min(end + 1, command.size()));
  }
  return "<pre class=\"command\"><code>" + words + "</code></pre>\n";
}

std::string json_script(std::string_view id, const nlohmann::ordered_json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);  // nothing ends the element
  return "<script type=\"application/json\" id=\"" + std::string(id) + "\">" + text + "</script>\n";
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;  // three bytes, missing ones zero
    for (std::size_t j = 0; j < 3; ++j) {
      group = group << 8U | (i + j < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const bool padding = i + j > bytes.size();
      text += padding ? '=' : kDigits[group >> (18U - 6U * j) & 63U];
    }
  }
  return text;
}

}  // namespace penumbra::study
