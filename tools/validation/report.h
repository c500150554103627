// What a run of validation found, record by record, and the forms it is told in.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"

namespace penumbra::validation {

// absent: techniques.json says the target does without this technique, and it does fail there. unreached:
// there was no SPIR-V to make the target from; its failure is reported once, under "spirv". unchecked: it
// could not be tried here, for a reason that is not the shader's (a file that only the Unity editor has).
enum class VariantStatus { passed, failed, absent, unreached, unchecked };

// One entry point of one file with one keyword set for one target.
struct VariantRecord {
  std::string technique;  // of techniques.json; empty for a user's file
  std::string file;
  std::string shader;  // ShaderLab name, "Universal Render Pipeline/Lit"; empty outside ShaderLab
  std::string pass;    // "ForwardLit", or "0.2" (subshader.pass, from 0) where a pass has no name
  std::string entry;
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::string> keywords;
  std::string target;
  VariantStatus status = VariantStatus::passed;
  std::vector<hlsl::Diagnostic> diagnostics;
  std::string reason;        // why it is absent or unchecked
  bool cached = false;       // the answer is of an earlier run
  std::string reproduction;  // a file with the text that crashed or hung a compiler; empty without
};

struct ValidationReport {
  std::vector<VariantRecord> records;  // in the order of the request, whatever the number of jobs
  std::size_t unique = 0;              // distinct pairs of SPIR-V module and target among them
  double seconds = 0.0;
  std::map<std::string, std::string> checks;  // target -> who has checked it

  std::size_t count(VariantStatus status) const;
};

const char* status_name(VariantStatus status);  // as the enumerator is spelt

std::string report_text(const ValidationReport& report);  // findings, then one line of totals
std::string report_json(const ValidationReport& report);

}  // namespace penumbra::validation
