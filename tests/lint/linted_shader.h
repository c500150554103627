// Compiles one HLSL text and runs every rule of one module over it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lint/module_rules.h"
#include "shaders/compile.h"

namespace penumbra::lint {

inline shaders::CompileRequest request_of(const std::string& text, hlsl::Stage stage) {
  shaders::CompileRequest request;
  request.file = "Test.hlsl";
  request.text = text;
  request.stage = stage;
  return request;
}

inline shaders::CompileResult compiled(shaders::CompileRequest request) {
  request.optimise = false;
  request.debug_lines = true;
  shaders::CompileResult result = shaders::compile(request);
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity == hlsl::Severity::error)
      ADD_FAILURE() << hlsl::format(diagnostic) << "\n" << (request.text ? *request.text : request.entry);
  return result;
}

inline shaders::CompileResult compiled(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment) {
  return compiled(request_of(text, stage));
}

// The findings with the legalised module of the compiler, as `penumbra validate` has it; nothing where the
// module cannot be optimised.
inline std::optional<std::vector<hlsl::Diagnostic>> lint_as_compiled(shaders::CompileRequest request,
                                                                     int shader_target) {
  request.keep_unoptimised = true;
  shaders::CompileResult result = shaders::compile(request);
  if (result.spirv.empty()) return std::nullopt;
  return lint_module({std::move(result.unoptimised), request.stage, request.file.string(),
                      std::move(result.sources), shader_target, std::move(result.legalised)});
}

// The finding as "3:5 error rule: message", or "3 ..." where the column is unknown.
inline std::string told(const hlsl::Diagnostic& at) {
  const char* severity = at.severity == hlsl::Severity::error     ? " error "
                         : at.severity == hlsl::Severity::warning ? " warning "
                                                                  : " note ";
  return std::to_string(at.line) + (at.column == 0 ? "" : ":" + std::to_string(at.column)) + severity +
         at.rule + ": " + at.message;
}

inline std::vector<std::string> told(const std::vector<hlsl::Diagnostic>& findings) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& finding : findings) all.push_back(told(finding));
  return all;
}

inline std::vector<hlsl::Diagnostic> lint(const shaders::CompileRequest& request, int shader_target = 0) {
  shaders::CompileResult result = compiled(request);
  if (result.spirv.empty()) return {};
  std::vector<hlsl::Diagnostic> findings =
      lint_module({std::move(result.spirv), request.stage, request.file.string(), std::move(result.sources),
                   shader_target});
  if (const auto as_compiled = lint_as_compiled(request, shader_target)) {
    EXPECT_EQ(told(*as_compiled), told(findings)) << (request.text ? *request.text : request.entry);
  }
  return findings;
}

inline std::vector<hlsl::Diagnostic> lint(const std::string& text, hlsl::Stage stage = hlsl::Stage::fragment,
                                          int shader_target = 0) {
  return lint(request_of(text, stage), shader_target);
}

// Every finding of the rule, in order.
inline std::vector<std::string> findings_of(const std::string& rule, const std::string& text,
                                            hlsl::Stage stage = hlsl::Stage::fragment,
                                            int shader_target = 0) {
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& finding : lint(text, stage, shader_target))
    if (finding.rule == rule) all.push_back(told(finding));
  return all;
}

// A fragment shader that returns the expression, after the statements.
inline std::string fragment(const std::string& statements, const std::string& expression,
                            const std::string& before = {}) {
  return before +
         "float4 Main(float2 uv : TEXCOORD0, nointerpolation int flat : TEXCOORD1) : SV_Target\n{\n" +
         statements + "    return " + expression + ";\n}\n";
}

}  // namespace penumbra::lint
