#include "architecture/source_lines.h"

#include <regex>
#include <sstream>

namespace penumbra::architecture {

void for_each_line(const std::string& text,
                   const std::function<void(int line, const std::string& text)>& visit) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) visit(number, line);
}

std::vector<Include> includes_of(const Tree& tree, std::string_view prefix) {
  static const std::regex include(R"re(^\s*#\s*include(?:_with_pragmas)?\s*[<"]([^>"]+)[>"])re");
  static const std::regex source(R"re(.*\.(h|hpp|cpp|hlsl|shader|compute))re");
  std::vector<Include> found;
  for (const auto& [path, text] : tree) {
    if (!path.starts_with(prefix) || !std::regex_match(path, source)) continue;
    for_each_line(text, [&, &file = path](int number, const std::string& line) {
      std::smatch match;
      if (std::regex_search(line, match, include)) found.push_back({file, number, match[1]});
    });
  }
  return found;
}

std::string violation(const std::string& path, int line, const std::string& why) {
  return path + ":" + std::to_string(line) + ": " + why;
}

std::string folder_below(std::string_view path, std::string_view prefix) {
  if (!path.starts_with(prefix)) return {};
  path.remove_prefix(prefix.size());
  const std::size_t end = path.find('/');
  return end == std::string_view::npos ? std::string() : std::string(path.substr(0, end));
}

}  // namespace penumbra::architecture
