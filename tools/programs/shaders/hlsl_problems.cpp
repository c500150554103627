#include "shaders/hlsl_problems.h"

#include <algorithm>
#include <utility>

#include "shaders/derivative_reads.h"
#include "shaders/generated_words.h"
#include "shaders/lost_resources.h"
#include "shaders/misread_textures.h"
#include "shaders/refused_instructions.h"
#include "shaders/refused_memory.h"
#include "shaders/texel_offsets.h"
#include "shaders/zero_divisions.h"

namespace penumbra::shaders {

namespace {

void append(std::vector<hlsl::Diagnostic>& all, std::vector<hlsl::Diagnostic> more) {
  for (hlsl::Diagnostic& problem : more) all.push_back(std::move(problem));
}

std::vector<hlsl::Diagnostic> shown_by(const SpirvModule& module, hlsl::Stage stage) {
  std::vector<hlsl::Diagnostic> problems = lost_resources(module);
  append(problems, misread_textures(module));
  append(problems, refused_offsets(module));
  append(problems, refused_memory(module, stage));
  append(problems, refused_instructions(module, stage));
  return problems;
}

// Finds reachable divisions by a constant zero; a division x / x in the source itself looks like a mark and
// is excluded.
std::vector<hlsl::Diagnostic> divisions_by_zero(const glslang::TIntermediate& tree, VulkanVersion vulkan) {
  spv::SpvBuildLogger messages;
  SpirvModule marked = generated_words(tree, true, messages);
  SpirvModule plain = marked;
  mark_zero_divisions(marked);
  std::vector<std::string> ignored;
  if (!optimise(marked, vulkan, ignored) || !optimise(plain, vulkan, ignored)) return {};
  std::vector<hlsl::Diagnostic> found = marked_divisions(marked);
  const std::vector<hlsl::Diagnostic> own = marked_divisions(plain);
  std::erase_if(found, [&](const hlsl::Diagnostic& problem) {
    return std::find(own.begin(), own.end(), problem) != own.end();
  });
  return found;
}

}  // namespace

std::vector<hlsl::Diagnostic> hlsl_problems(const CompileRequest& request, const glslang::TIntermediate& tree,
                                            const SpirvModule& optimised, bool divides) {
  std::vector<hlsl::Diagnostic> problems = shown_by(optimised, request.stage);
  std::vector<hlsl::Diagnostic> derivatives;
  if (request.stage != hlsl::Stage::fragment)
    derivatives = derivative_reads(tree, hlsl::stage_name(request.stage));
  if (problems.empty() && derivatives.empty() && !divides) return {};
  const SpirvModule lined = words_with_lines(tree, true, request.vulkan);
  if (std::vector<hlsl::Diagnostic> placed = shown_by(lined, request.stage); !placed.empty())
    problems = std::move(placed);
  append(problems, remaining(std::move(derivatives), lined));
  if (divides) append(problems, divisions_by_zero(tree, request.vulkan));
  return problems;
}

}  // namespace penumbra::shaders
