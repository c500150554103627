// Lint of whole shaders: rules that need all variants and all passes (lint/program_rules.h).
//
// Keywords are checked in programs whose variants were all requested: in a sample, with narrowed keywords or
// in one shard of several, code that never changes there may change elsewhere. Constant buffers are always
// compared, for the first graphics API of the request, in SubShaders of a scriptable pipeline: those with the
// tag RenderPipeline or a UnityPerMaterial. Variants with instancing keywords are not batched and not
// compared.
#pragma once

#include <string>
#include <vector>

#include "lint/program_rules.h"
#include "validation/report.h"
#include "validation/unit.h"

namespace penumbra::validation {

// A program of a pass, kernel file or .hlsl file, by the names that its units have.
struct ProgramToLint {
  std::string file;
  std::string shader;
  std::string pass;
  int sub_shader = 0;
  bool scriptable_pipeline = false;                // its SubShader or Pass has the tag RenderPipeline
  std::vector<lint::NamedPlace> keywords;          // keywords that its pragmas declare
  bool is_whole = false;                           // every variant of its keywords is among the units
  std::vector<lint::MaterialProperty> properties;  // properties of its shader: numbers, colours, vectors
};

// Returns one record for each file with findings, with target whole_source. results[i] is that of
// units[results[i].unit].
std::vector<VariantRecord> program_findings(const std::vector<ProgramToLint>& programs,
                                            const std::vector<CompileUnit>& units,
                                            const std::vector<UnitResult>& results, const LintOrder& order);

}  // namespace penumbra::validation
