// Compiles every technique with every keyword set, and files of a user's own, for every target.
//
// A variant is one entry point of one file with one keyword set for one target. "spirv" means compiled by
// glslang and valid for SPIRV-Tools. essl310 and glsl450 mean emitted by SPIRV-Cross and compiled and linked
// by this machine's GL driver. msl23 and hlsl50 mean emitted only, because no Metal or Direct3D compiler is
// available here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shaders/compile.h"
#include "techniques/technique_list.h"
#include "validation/engine.h"
#include "validation/program_lint.h"
#include "validation/report.h"

namespace penumbra::validation {

// A shader file to compile besides, or instead of, the techniques.
struct ShaderToValidate {
  std::filesystem::path file;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::vector<std::vector<std::string>> keyword_sets{{}};
};

struct ValidationRequest {
  std::optional<techniques::TechniqueList> techniques;
  std::vector<ShaderToValidate> files;
  std::vector<std::string> targets{"spirv", "essl310", "glsl450", "msl23", "hlsl50"};
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<shaders::PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::vector<CompileUnit> units;       // further units, which ShaderSources made of shader files
  std::vector<VariantRecord> records;   // further records, from before the compilation of those files
  std::vector<ProgramToLint> programs;  // the shaders of those files
  std::vector<std::string> packages;    // see ValidationReport
  LintOrder lint;                       // for techniques and files; units have their own
  bool minimise = false;                // finds the minimal keywords of what fails
  EngineOptions engine;
};

// Throws InputError when a file cannot be read, EnvironmentError when GL is needed and not there, and
// platform::Interrupted.
ValidationReport validate(const ValidationRequest& request);

}  // namespace penumbra::validation
