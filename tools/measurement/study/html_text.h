// Encodes text and pictures for HTML.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

namespace penumbra::study {

// The result is safe in element content and in quoted attributes: & < > " ' are escaped; control characters
// (tab and line feed apart) and bytes that are not valid UTF-8 are replaced by U+FFFD.
std::string escape_html(std::string_view text);

// Returns a command as a block of code, escaped: lines wrap between its words, never at the hyphens of an
// option.
std::string command_html(std::string_view command);

// Returns data for the page's script, which it finds by the id.
std::string json_script(std::string_view id, const nlohmann::ordered_json& data);

// The encoding is that of RFC 4648, padded.
std::string base64(std::span<const std::byte> bytes);

}  // namespace penumbra::study
