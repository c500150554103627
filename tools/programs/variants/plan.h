// The amount of work, counted before any of it starts.
#pragma once

#include "hlsl/stage.h"
#include "variants/keyword_space.h"
#include "variants/variant_count.h"

namespace penumbra::variants {

struct PlannedProgram {
  std::string name;  // "Lit.shader: ForwardLit"
  const KeywordSpace* space = nullptr;
  std::vector<hlsl::Stage> stages;  // the program's stages; one compute stage for each kernel
  std::uint64_t targets = 1;        // that each variant is compiled for
};

struct StagePlan {
  hlsl::Stage stage = hlsl::Stage::vertex;
  VariantCount variants;
};

struct ProgramPlan {
  std::string name;
  std::vector<StagePlan> stages;
  VariantCount results;  // one for each variant and target
};

struct Plan {
  std::vector<ProgramPlan> programs;
  VariantCount results;
};

Plan plan(const std::vector<PlannedProgram>& programs);

std::string results_text(VariantCount results);  // "1 result", "8,192 results"

// Returns a line "Lit.shader: ForwardLit   vertex 512   fragment 8,192" for each program, with its variants,
// and the number of results.
std::string text_of(const Plan& plan);

// Returns the same, with the changed count in parentheses after each: "vertex 512 (256)". `what_if` counts
// the same programs, and `condition` in the last line names the change.
std::string text_of(const Plan& plan, const Plan& what_if, const std::string& condition);

// Returns an empty text if the results are within the limit. Otherwise it has their number, the largest
// programs, the sets that multiply the number most, with the number left if each were fixed at its empty
// keyword (or its first) in all programs, and advice on how to narrow them.
std::string refusal(const std::vector<PlannedProgram>& programs, std::uint64_t limit);

}  // namespace penumbra::variants
