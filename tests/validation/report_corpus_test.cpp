// Broken shaders, one mistake each: every one gives one message, at the place and in the words that its first
// line asks for.
//
// The first line is a comment: file:line:column: severity: text, the file relative to the folder. A second
// line
// "// compile: --stage compute --entry Start -D NAME=VALUE" says how, where it is not fragment, Main and no
// define. Packages/com.example.tools/ is the folder packages/tools.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::validation {
namespace {

namespace fs = std::filesystem;

fs::path corpus() {
  return fs::path(PENUMBRA_SOURCE_DIR) / "tests" / "validation" / "broken";
}

std::vector<std::string> files_ending_in(const std::string& extension) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(corpus()))
    if (entry.path().extension() == extension) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> first_two_lines(const std::string& name) {
  std::ifstream file(corpus() / name, std::ios::binary);
  std::vector<std::string> lines(2);
  for (std::string& line : lines) std::getline(file, line);
  return lines;
}

void apply(const std::string& line, shaders::CompileRequest& request) {
  const std::string start = "// compile: ";
  if (line.compare(0, start.size(), start) != 0) return;
  std::istringstream words(line.substr(start.size()));
  for (std::string option, value; words >> option >> value;) {
    const std::size_t equals = value.find('=');
    if (option == "--stage") {
      request.stage = hlsl::find_stage(value).value();
    } else if (option == "--entry") {
      request.entry = value;
    } else {
      ASSERT_EQ(option, "-D");
      request.defines.emplace_back(value.substr(0, equals), value.substr(equals + 1));
    }
  }
}

// The message as it is printed, with the names in it relative to the folder.
std::string relative(std::string text) {
  const std::string prefix = corpus().string() + "/";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at))
    text.erase(at, prefix.size());
  return text;
}

std::string headline(hlsl::Diagnostic diagnostic) {
  diagnostic.source_line.clear();
  return relative(format(diagnostic));
}

class BrokenShader : public testing::TestWithParam<std::string> {};

TEST_P(BrokenShader, GivesTheOneMessageItsFirstLineAsksFor) {
  const std::vector<std::string> lines = first_two_lines(GetParam());
  shaders::CompileRequest request;
  request.file = corpus() / GetParam();
  request.stage = hlsl::Stage::fragment;
  request.package_roots = {{"com.example.tools", corpus() / "packages" / "tools"}};
  apply(lines[1], request);
  const shaders::CompileResult result = shaders::compile(request);
  std::vector<std::string> messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) messages.push_back(headline(diagnostic));
  EXPECT_THAT(messages, testing::ElementsAre(lines[0].substr(3)));
  EXPECT_EQ(result.spirv.empty(), hlsl::has_errors(result.diagnostics));
}

INSTANTIATE_TEST_SUITE_P(Hlsl, BrokenShader, testing::ValuesIn(files_ending_in(".hlsl")),
                         [](const testing::TestParamInfo<std::string>& shader) {
                           return fs::path(shader.param).stem().string();
                         });

}  // namespace
}  // namespace penumbra::validation
