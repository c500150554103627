// Shader files: the tree of a .shader, the kernels of a .compute.
#include <algorithm>
#include "fuzz/fuzz_input.h"
#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "shaderlab/use_pass.h"
#include "variants/pragmas.h"

namespace {

using namespace penumbra;

void show(const std::vector<hlsl::Diagnostic>& messages) {
  int line = 0, errors = 0;
  for (const hlsl::Diagnostic& message : messages) {
    fuzz::require_harmless(hlsl::format(message));
    fuzz::require(message.line >= line, "messages are in the order of the file");
    line = message.line;
    errors += message.severity == hlsl::Severity::error ? 1 : 0;
  }
  fuzz::require(errors <= 1, "at most one error");
}

void read_programs(const shaderlab::Shader& shader) {
  for (const shaderlab::Program& program : shaderlab::programs(shader)) {
    shaderlab::pass_name(program);
    shaderlab::effective_tag(program, "LightMode");
    variants::read_pragmas({program.file, program.text, {}, {}});
  }
  for (const shaderlab::SubShader& sub_shader : shader.sub_shaders)
    for (const shaderlab::Pass& pass : sub_shader.passes)
      if (pass.kind == shaderlab::Pass::Kind::use_pass) shaderlab::resolve_use_pass(shader, pass, {&shader});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const shaderlab::ParsedShader parsed = shaderlab::parse_shader(text, "a.shader");
  show(parsed.diagnostics);
  read_programs(parsed.shader);
  for (const hlsl::Diagnostic& message : shaderlab::compute_kernels(text, "a.compute").diagnostics)
    fuzz::require_harmless(hlsl::format(message));
  return 0;
}
