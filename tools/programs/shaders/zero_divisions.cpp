#include "shaders/zero_divisions.h"

#include <algorithm>
#include <set>

#include "shaders/debug_lines.h"

namespace penumbra::shaders {

namespace {

bool divides_integers(spirv::Words instruction) {
  const spv::Op op = spirv::opcode(instruction);
  const bool divides =
      op == spv::OpUDiv || op == spv::OpSDiv || op == spv::OpUMod || op == spv::OpSRem || op == spv::OpSMod;
  return divides && instruction.size() == 5;
}

// Constants that are zero in one component at least.
class Zeros {
 public:
  void visit(spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpConstant && instruction.size() == 4 && instruction[3] == 0) ids_.insert(instruction[2]);
    if (op == spv::OpConstantNull && instruction.size() == 3) ids_.insert(instruction[2]);
    if (op == spv::OpConstantComposite && instruction.size() > 3 &&
        std::any_of(instruction.begin() + 3, instruction.end(),
                    [this](std::uint32_t id) { return contain(id); }))
      ids_.insert(instruction[2]);
  }
  bool contain(std::uint32_t id) const { return ids_.count(id) != 0; }

 private:
  std::set<std::uint32_t> ids_;
};

// Returns the words at which divisions by zero begin.
std::vector<std::size_t> zero_divisions(const SpirvModule& module) {
  std::vector<std::size_t> found;
  Zeros zeros;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    zeros.visit(instruction);
    if (divides_integers(instruction) && zeros.contain(instruction[4]))
      found.push_back(static_cast<std::size_t>(instruction.data() - module.data()));
  });
  return found;
}

}  // namespace

bool divides_by_zero(const SpirvModule& unoptimised) {
  return !zero_divisions(unoptimised).empty();
}

void mark_zero_divisions(SpirvModule& unoptimised) {
  for (const std::size_t at : zero_divisions(unoptimised)) unoptimised[at + 4] = unoptimised[at + 3];
}

std::vector<hlsl::Diagnostic> marked_divisions(const SpirvModule& optimised) {
  std::vector<hlsl::Diagnostic> problems;
  DebugLines lines;
  spirv::for_each_instruction(optimised, [&](spirv::Words instruction) {
    const SourcePlace& place = lines.visit(instruction);
    if (!divides_integers(instruction) || instruction[3] != instruction[4]) return;
    hlsl::Diagnostic problem = error_at(place, "an integer is divided by zero");
    if (std::find(problems.begin(), problems.end(), problem) == problems.end())
      problems.push_back(std::move(problem));
  });
  return problems;
}

}  // namespace penumbra::shaders
