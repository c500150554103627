// Compiles broken shaders with one mistake each: every one gives one message, at the place and in the words
// that its first line asks for.
//
// The first line is a comment: file:line:column: severity: text, the file relative to the folder. A second
// line "// compile: --stage compute --entry Start -D NAME=VALUE" says how, where it is not fragment, Main and
// no define. Packages/com.example.tools/ is the folder packages/tools.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "hlsl/source_text.h"
#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "shaders/compile.h"
#include "variants/pragmas.h"

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

void take_options(const std::string& line, shaders::CompileRequest& request) {
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

shaders::CompileRequest request_for(const std::string& name) {
  shaders::CompileRequest request;
  request.file = corpus() / name;
  request.stage = hlsl::Stage::fragment;
  request.package_roots = {{"com.example.tools", corpus() / "packages" / "tools"}};
  request.prepare = true;
  return request;
}

using Diagnostics = std::vector<hlsl::Diagnostic>;

// The outcome of one file: its messages and whether it may be used all the same.
struct Outcome {
  Diagnostics diagnostics;
  bool compiled = true;
};

void add(Outcome& outcome, const Diagnostics& more) {
  for (const hlsl::Diagnostic& diagnostic : more)
    if (diagnostic.severity != hlsl::Severity::note) outcome.diagnostics.push_back(diagnostic);
  outcome.compiled = outcome.compiled && !hlsl::has_errors(more);
}

void compile_into(const shaders::CompileRequest& request, Outcome& outcome) {
  const shaders::CompileResult result = shaders::compile(request);
  add(outcome, result.diagnostics);
  outcome.compiled = outcome.compiled && !result.spirv.empty();
}

Outcome compile_hlsl(const std::string& name) {
  Outcome outcome;
  shaders::CompileRequest request = request_for(name);
  take_options(first_two_lines(name)[1], request);
  compile_into(request, outcome);
  return outcome;
}

std::string text_of(const std::string& name) {
  return hlsl::read_source(corpus() / name).text;
}

// Compiles every program with the entry points that its pragmas name.
Outcome compile_shader(const std::string& name) {
  Outcome outcome;
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(text_of(name), (corpus() / name).string());
  add(outcome, parsed.diagnostics);
  if (!outcome.compiled) return outcome;
  for (const shaderlab::Program& program : shaderlab::programs(parsed.shader)) {
    const variants::Pragmas pragmas = variants::read_pragmas({program.file, program.text, {}, {}});
    add(outcome, pragmas.diagnostics);
    for (const variants::EntryPoint& entry : pragmas.entry_points) {
      shaders::CompileRequest request = request_for(name);
      request.text = program.text;
      request.stage = entry.stage;
      request.entry = entry.function;
      Outcome stage;
      compile_into(request, stage);
      outcome.compiled = outcome.compiled && stage.compiled;
      for (const hlsl::Diagnostic& diagnostic : stage.diagnostics)  // one mistake may fail every stage
        if (outcome.diagnostics.empty() || format(outcome.diagnostics.back()) != format(diagnostic))
          outcome.diagnostics.push_back(diagnostic);
    }
  }
  return outcome;
}

Outcome compile_kernels(const std::string& name) {
  Outcome outcome;
  const shaderlab::ComputeKernels compute =
      shaderlab::compute_kernels(text_of(name), (corpus() / name).string());
  add(outcome, compute.diagnostics);
  for (const shaderlab::Kernel& kernel : compute.kernels) {
    shaders::CompileRequest request = request_for(name);
    request.stage = hlsl::Stage::compute;
    request.entry = kernel.function.text;
    for (const shaderlab::KernelDefine& define : kernel.defines)
      request.defines.emplace_back(define.macro.text, define.value);
    compile_into(request, outcome);
  }
  return outcome;
}

Outcome compile_file(const std::string& name) {
  if (name.ends_with(".shader")) return compile_shader(name);
  return name.ends_with(".compute") ? compile_kernels(name) : compile_hlsl(name);
}

class BrokenShader : public testing::TestWithParam<std::string> {};

TEST_P(BrokenShader, GivesTheOneMessageItsFirstLineAsksFor) {
  const Outcome outcome = compile_file(GetParam());
  std::vector<std::string> messages;
  for (const hlsl::Diagnostic& diagnostic : outcome.diagnostics) messages.push_back(headline(diagnostic));
  EXPECT_THAT(messages, testing::ElementsAre(first_two_lines(GetParam())[0].substr(3)));
  EXPECT_EQ(outcome.compiled, !hlsl::has_errors(outcome.diagnostics));
}

std::string test_name(const testing::TestParamInfo<std::string>& shader) {
  return fs::path(shader.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(Hlsl, BrokenShader, testing::ValuesIn(files_ending_in(".hlsl")), test_name);
INSTANTIATE_TEST_SUITE_P(ShaderLab, BrokenShader, testing::ValuesIn(files_ending_in(".shader")), test_name);
INSTANTIATE_TEST_SUITE_P(Compute, BrokenShader, testing::ValuesIn(files_ending_in(".compute")), test_name);

TEST(Corpus, HasFortyBrokenShadersAndMore) {
  EXPECT_GE(files_ending_in(".hlsl").size() + files_ending_in(".shader").size(), 40u);
}

}  // namespace
}  // namespace penumbra::validation
