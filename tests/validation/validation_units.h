// Makes small units for tests of the engine, and results in a form that can be compared and printed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shaders/shader_files.h"
#include "validation/engine.h"

namespace penumbra::validation {

// The workers are this test program: the first does what the product's do; the second misbehaves where the
// define MISBEHAVE says so: "crash@msl23", "hang@spirv", "eat@preprocess", "kill@spirv"; see worker_main.cpp.
inline constexpr const char* misbehaving_mode = "--misbehaving-worker";

inline CompileUnit fragment_unit(const std::filesystem::path& file, std::vector<std::string> keywords = {}) {
  CompileUnit unit;
  unit.file = file.string();
  unit.keywords = keywords;
  unit.compile.file = file;
  unit.compile.stage = hlsl::Stage::fragment;
  for (const std::string& keyword : keywords) unit.compile.defines.emplace_back(keyword, "1");
  unit.targets = {"spirv", "msl23", "hlsl50"};
  return unit;
}

inline CompileUnit misbehaving(CompileUnit unit, const std::string& how) {
  unit.compile.defines.emplace_back("MISBEHAVE", how);
  return unit;
}

// Prints everything that must not depend on how a run was made.
inline std::string told(const UnitResult& result) {
  std::string text = std::to_string(result.unit) + " " + result.text_key + " " + result.module_key + "\n";
  for (const TargetResult& target : result.targets)
    text += std::string("  ") + status_name(target.status) + "\n" + encode(target.diagnostics) + "\n";
  for (const std::filesystem::path& file : result.dependencies) text += "  " + file.string() + "\n";
  return text;
}

inline std::vector<std::string> told(const EngineRun& run) {
  std::vector<std::string> texts;
  for (const UnitResult& result : run.results) texts.push_back(told(result));
  return texts;
}

inline std::size_t cached_count(const EngineRun& run) {
  std::size_t count = 0;
  for (const UnitResult& result : run.results) count += result.cached ? 1 : 0;
  return count;
}

}  // namespace penumbra::validation
