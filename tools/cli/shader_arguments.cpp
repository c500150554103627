#include "cli/shader_arguments.h"

#include <algorithm>
#include <sstream>

#include "input/input_error.h"

namespace penumbra::cli {

std::vector<std::string> parse_keyword_set(const std::string& text) {
  std::vector<std::string> keywords;
  std::istringstream stream(text);
  for (std::string keyword; std::getline(stream, keyword, ',');)
    if (!keyword.empty()) keywords.push_back(keyword);
  return keywords;
}

std::pair<std::string, std::string> parse_define(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  return {text.substr(0, equals), equals == text.size() ? "1" : text.substr(equals + 1)};
}

shaders::PackageRoot parse_package_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--package-root", "'" + text + "' is not NAME=DIR",
                     "for example com.unity.render-pipelines.core=/packages/core");
  shaders::PackageRoot root{text.substr(0, equals), text.substr(equals + 1)};
  if (!std::filesystem::is_directory(root.directory))
    throw EnvironmentError("the package root of " + root.name + " is not a folder: '" +
                           root.directory.string() + "'");
  return root;
}

}  // namespace penumbra::cli
