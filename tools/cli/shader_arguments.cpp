#include "cli/shader_arguments.h"

#include <algorithm>
#include <sstream>

#include "hlsl/identifier.h"
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
  const std::string name = text.substr(0, std::min(text.find('('), equals));
  if (!hlsl::is_identifier(name))
    throw InputError(
        "-D",
        "'" + name + "' is not a macro's name, which has letters, digits and '_' and begins with no digit",
        "for example -D _QUALITY=2");
  return {text.substr(0, equals), equals == text.size() ? "1" : text.substr(equals + 1)};
}

shaders::PackageRoot parse_package_root(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError("--package-root", "'" + text + "' is not NAME=FOLDER",
                     "for example com.unity.render-pipelines.core=/packages/core");
  shaders::PackageRoot root{text.substr(0, equals), text.substr(equals + 1)};
  if (!std::filesystem::is_directory(root.directory))
    throw EnvironmentError("the package root of " + root.name + " is not a folder: '" +
                           root.directory.string() + "'");
  return root;
}

}  // namespace penumbra::cli
