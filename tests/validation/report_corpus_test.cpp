// Compiles broken shaders with one mistake each: every one gives the one message in its first line, at the
// place and in the words that shaders/expected_messages.h explains. Packages/com.example.tools/ is the folder
// packages/tools.
#include <gtest/gtest.h>

#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "shaders/expected_messages.h"
#include "variants/pragmas.h"

namespace penumbra::validation {
namespace {

namespace fs = std::filesystem;
using shaders::CompileRequest;

// Every program with the entry points that its pragmas name.
std::vector<CompileRequest> requests_for_programs(const fs::path& file, std::vector<hlsl::Diagnostic>& said) {
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(hlsl::read_source(file).text, file.string());
  said = parsed.diagnostics;
  std::vector<CompileRequest> requests;
  if (hlsl::has_errors(said)) return requests;
  for (const shaderlab::Program& program : shaderlab::programs(parsed.shader)) {
    const variants::Pragmas pragmas = variants::read_pragmas({program.file, program.text, {}, {}});
    said.insert(said.end(), pragmas.diagnostics.begin(), pragmas.diagnostics.end());
    for (const variants::EntryPoint& entry : pragmas.entry_points) {
      CompileRequest request = shaders::request_for(file);
      request.text = program.text;
      request.stage = entry.stage;
      request.entry = entry.function;
      requests.push_back(request);
    }
  }
  return requests;
}

std::vector<CompileRequest> requests_for_kernels(const fs::path& file, std::vector<hlsl::Diagnostic>& said) {
  const shaderlab::ComputeKernels compute =
      shaderlab::compute_kernels(hlsl::read_source(file).text, file.string());
  said = compute.diagnostics;
  std::vector<CompileRequest> requests;
  for (const shaderlab::Kernel& kernel : compute.kernels) {
    CompileRequest request = shaders::request_for(file);
    request.stage = hlsl::Stage::compute;
    request.entry = kernel.function.text;
    for (const shaderlab::KernelDefine& define : kernel.defines)
      request.defines.emplace_back(define.macro.text, define.value);
    requests.push_back(request);
  }
  return requests;
}

class BrokenShader : public testing::TestWithParam<fs::path> {};

TEST_P(BrokenShader, GivesTheOneMessageItsFirstLineAsksFor) {
  const fs::path& file = GetParam();
  std::vector<hlsl::Diagnostic> said;
  std::vector<CompileRequest> requests;
  if (file.extension() == ".shader")
    requests = requests_for_programs(file, said);
  else if (file.extension() == ".compute")
    requests = requests_for_kernels(file, said);
  else
    requests = shaders::requests_for(file);
  shaders::Messages messages(file);
  messages.add(said);
  bool compiled = !hlsl::has_errors(said);
  bool is_error = !compiled;
  for (const CompileRequest& request : requests) {
    const shaders::CompileResult result = shaders::compile(request);
    messages.add(result.diagnostics);
    compiled = compiled && !result.spirv.empty();
    is_error = is_error || hlsl::has_errors(result.diagnostics);
  }
  if (file.extension() == ".shader") messages.remove_repeated();
  const std::string expected = shaders::expected_of(file).messages;
  EXPECT_EQ(messages.text(), expected) << file;
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), 1) << file;
  EXPECT_EQ(compiled, !is_error) << file;
}

INSTANTIATE_TEST_SUITE_P(Hlsl, BrokenShader,
                         testing::ValuesIn(shaders::files_of("validation/broken", ".hlsl")),
                         shaders::name_of_file);
INSTANTIATE_TEST_SUITE_P(ShaderLab, BrokenShader,
                         testing::ValuesIn(shaders::files_of("validation/broken", ".shader")),
                         shaders::name_of_file);
INSTANTIATE_TEST_SUITE_P(Compute, BrokenShader,
                         testing::ValuesIn(shaders::files_of("validation/broken", ".compute")),
                         shaders::name_of_file);

TEST(Corpus, HasFortyBrokenShadersAndMore) {
  EXPECT_GE(shaders::files_of("validation/broken", ".hlsl").size() +
                shaders::files_of("validation/broken", ".shader").size(),
            40u);
}

}  // namespace
}  // namespace penumbra::validation
