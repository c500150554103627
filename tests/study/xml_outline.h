// Checks the tags of an XML text for balance: enough to say whether an SVG is one that parses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::study {

// Returns "" when every tag closes in order, every '&' starts an entity and no stray '<' nor the end of a
// CDATA section stands in text; otherwise it returns what is wrong. It knows no CDATA sections.
inline std::string xml_fault(std::string_view text) {
  std::vector<std::string> open;
  if (text.find("]]>") != std::string_view::npos) return "the end of a CDATA section";
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '&') {
      const std::size_t end = text.find(';', at);
      if (end == std::string_view::npos || end - at > 8) return "a bare & at " + std::to_string(at);
    }
    if (text[at] != '<') continue;
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos) return "a tag without end at " + std::to_string(at);
    const std::string_view tag = text.substr(at + 1, end - at - 1);
    if (tag.empty() || tag.find('<') != std::string_view::npos) return "a stray < at " + std::to_string(at);
    const std::string name(
        tag.substr(tag.front() == '/' ? 1 : 0).substr(0, tag.find_first_of(" \t\r\n/", 1)));
    if (tag.front() == '/') {
      if (open.empty() || name.substr(0, open.back().size()) != open.back())
        return "</" + name + "> unopened";
      open.pop_back();
    } else if (tag.front() != '?' && tag.front() != '!' && tag.back() != '/') {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() ? "" : "<" + open.back() + "> unclosed";
}

}  // namespace penumbra::study
