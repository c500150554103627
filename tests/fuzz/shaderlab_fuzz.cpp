// Reads shader files: the tree of a .shader, the kernels of a .compute.
#include <limits>
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "variants/pragmas.h"

namespace penumbra::fuzz {

namespace {

void show(const std::vector<hlsl::Diagnostic>& messages, bool complete) {
  int line = 0, errors = 0;
  for (const hlsl::Diagnostic& message : messages) {
    require_harmless(hlsl::format(message));
    // Line 0 stands for the whole file, which comes last.
    const int place = message.line == 0 ? std::numeric_limits<int>::max() : message.line;
    require(place >= line, "messages are in the order of the file");
    line = place;
    errors += message.severity == hlsl::Severity::error ? 1 : 0;
  }
  require(complete || errors > 0, "an error says why the tree is not complete");
}

void read_programs(const shaderlab::Shader& shader) {
  for (const shaderlab::Program& program : shaderlab::programs(shader)) {
    shaderlab::pass_name(program);
    shaderlab::effective_tag(program, "LightMode");
    variants::read_pragmas({program.file, program.text, {}, {}});
  }
}

}  // namespace

void targets::shaderlab(std::string_view bytes) {
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(bytes, "a.shader");
  show(parsed.diagnostics, parsed.complete);
  read_programs(parsed.shader);
  const shaderlab::ComputeKernels compute = shaderlab::compute_kernels(bytes, "a.compute");
  for (const hlsl::Diagnostic& message : compute.diagnostics) require_harmless(hlsl::format(message));
  for (const shaderlab::Kernel& kernel : compute.kernels)
    require(!kernel.function.text.empty(), "a kernel has a name");
}

}  // namespace penumbra::fuzz
