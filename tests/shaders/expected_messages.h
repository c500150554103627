// Shader files that say which messages they give: the comments in their first lines.
//
// Each message is one line, "// file:line:column: severity: text", the file relative to the folder, in the
// order of the lines; a rule of lint stands behind its text in brackets. A file without such a line gives no
// message. "// compile: --stage compute --entry Start -D NAME=VALUE" says how it is compiled where that is
// not fragment, Main and no define; each of several such lines compiles it once. #pragma use_dxc holds.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hlsl/source_text.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

// The files of a folder of the tests, not those of its folders.
inline std::vector<std::filesystem::path> files_of(const std::string& folder, const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests" / folder))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

inline std::string name_of_file(const testing::TestParamInfo<std::filesystem::path>& file) {
  return file.param.stem().string();
}

// The first lines of a file name its messages and its compilations.
struct Expected {
  std::string messages;  // one per line
  std::vector<std::string> compilations;
};

inline Expected expected_of(const std::filesystem::path& file) {
  Expected expected;
  std::istringstream lines(hlsl::read_source(file).text);
  const std::string compile = "// compile: ";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(compile))
      expected.compilations.push_back(line.substr(compile.size()));
    else if (line.starts_with("// ") &&
             (line.find(": error: ") != std::string::npos || line.find(": warning: ") != std::string::npos))
      expected.messages += line.substr(3) + "\n";
    else
      break;
  }
  return expected;
}

inline CompileRequest request_for(const std::filesystem::path& file, const std::string& options = "") {
  CompileRequest request;
  request.file = file;
  request.stage = hlsl::Stage::fragment;
  request.package_roots = {{"com.example.tools", file.parent_path() / "packages" / "tools"}};
  request.prepare = true;
  request.dxc = hlsl::read_source(file).text.find("#pragma use_dxc\n") != std::string::npos;
  std::istringstream words(options);
  for (std::string option, value; words >> option >> value;) {
    const std::size_t equals = value.find('=');
    if (option == "--stage") {
      request.stage = hlsl::find_stage(value).value();
    } else if (option == "--entry") {
      request.entry = value;
    } else {
      EXPECT_EQ(option, "-D") << file;
      request.defines.emplace_back(value.substr(0, equals), value.substr(equals + 1));
    }
  }
  return request;
}

inline std::vector<CompileRequest> requests_for(const std::filesystem::path& file) {
  std::vector<CompileRequest> requests;
  for (const std::string& options : expected_of(file).compilations)
    requests.push_back(request_for(file, options));
  if (requests.empty()) requests.push_back(request_for(file));
  return requests;
}

// The messages of a file as they are printed, with the names in them relative to its folder.
class Messages {
 public:
  explicit Messages(const std::filesystem::path& file) : folder_(file.parent_path().string() + "/") {}

  // Notes are left out.
  void add(const std::vector<hlsl::Diagnostic>& said) {
    for (hlsl::Diagnostic diagnostic : said) {
      if (diagnostic.severity == hlsl::Severity::note) continue;
      diagnostic.source_line.clear();
      if (!diagnostic.rule.empty()) diagnostic.message += " [" + diagnostic.rule + "]";
      all_.emplace_back(diagnostic.line, relative(format(diagnostic)));
    }
  }

  // One mistake may fail every stage of a program: its message is then one.
  void remove_repeated() {
    std::vector<Message> once;
    for (const Message& message : all_)
      if (std::find(once.begin(), once.end(), message) == once.end()) once.push_back(message);
    all_ = std::move(once);
  }

  std::string text() const {
    std::vector<Message> sorted = all_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Message& a, const Message& b) { return a.first < b.first; });
    std::string text;
    for (const Message& message : sorted) text += message.second + "\n";
    return text;
  }

 private:
  using Message = std::pair<int, std::string>;  // with its line

  std::string relative(std::string text) const {
    for (std::size_t at = text.find(folder_); at != std::string::npos; at = text.find(folder_, at))
      text.erase(at, folder_.size());
    return text;
  }

  std::string folder_;
  std::vector<Message> all_;
};

// Compiles an HLSL file as it asks for, and expects its messages; a module is made where there is no error.
inline void expect_messages_of(const std::filesystem::path& file, bool prepare = true) {
  Messages messages(file);
  for (CompileRequest& request : requests_for(file)) {
    request.prepare = prepare;
    const CompileResult result = compile(request);
    messages.add(result.diagnostics);
    EXPECT_EQ(result.spirv.empty(), hlsl::has_errors(result.diagnostics)) << file;
  }
  EXPECT_EQ(messages.text(), expected_of(file).messages) << file;
}

}  // namespace penumbra::shaders
