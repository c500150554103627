// Compiles every technique with every keyword set, and files of a user's own, for every target.
//
// A variant is one entry point of one file with one keyword set for one target. "spirv" means compiled by
// glslang and valid for SPIRV-Tools; essl310 and glsl450 mean emitted by SPIRV-Cross and compiled and linked
// by this machine's GL driver; msl23 and hlsl50 mean emitted only: no Metal or Direct3D compiler stands here.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shaders/compile.h"
#include "shaders/technique_list.h"

namespace penumbra::validation {

// A shader file to compile besides, or instead of, the techniques.
struct ShaderToValidate {
  std::filesystem::path file;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::vector<std::vector<std::string>> keyword_sets{{}};
};

struct ValidationRequest {
  std::optional<shaders::TechniqueList> techniques;
  std::vector<ShaderToValidate> files;
  std::vector<std::string> targets{"spirv", "essl310", "glsl450", "msl23", "hlsl50"};
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<shaders::PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  unsigned jobs = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // called by one thread at a time
};

// absent: techniques.json says the target does without this technique, and it does fail there. unreached:
// there was no SPIR-V to make the target from; its failure is reported once, under "spirv".
enum class VariantStatus { passed, failed, absent, unreached };

struct VariantRecord {
  std::string technique;  // empty for a user's file
  std::string file;
  std::string entry;
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::string> keywords;
  std::string target;
  VariantStatus status = VariantStatus::passed;
  std::vector<hlsl::Diagnostic> diagnostics;
  std::string absent_reason;
};

struct ValidationReport {
  std::vector<VariantRecord> records;  // in the order of the request, whatever the number of jobs
  std::size_t unique = 0;              // distinct pairs of SPIR-V module and target among them
  double seconds = 0.0;
  std::map<std::string, std::string> checks;  // target -> who has checked it

  std::size_t count(VariantStatus status) const;
};

// Throws InputError when a file cannot be read, EnvironmentError when GL is needed and not there, and
// platform::Interrupted.
ValidationReport validate(const ValidationRequest& request);

std::string validation_text(const ValidationReport& report);  // failures, absences, then one line of totals
std::string validation_json(const ValidationReport& report);

}  // namespace penumbra::validation
