#include <algorithm>
#include <set>

#include "lint/components.h"
#include "lint/control_flow.h"
#include "lint/known_values.h"
#include "lint/stage_rules.h"

namespace penumbra::lint {

namespace {

// The largest number of components of a result that FXC chooses without a branch.
constexpr std::size_t most_chosen = 16;

bool reads_texture(const spirv::Instruction& instruction, const std::set<spirv::Id>& readers) {
  if (instruction.op == spv::OpFunctionCall) return readers.contains(instruction.operands[0]);
  return instruction.op >= spv::OpImageSampleImplicitLod && instruction.op <= spv::OpImageQuerySamples &&
         instruction.op != spv::OpImageWrite && instruction.op != spv::OpImage;
}

// Returns the functions that read a texture, by themselves or by a call: FXC inlines all of them.
std::set<spirv::Id> texture_readers(const spirv::Code& code) {
  std::set<spirv::Id> readers;
  for (std::size_t before = 1; before != readers.size();) {
    before = readers.size();
    for (const spirv::Function& function : code.functions())
      for (const spirv::Block& block : function.blocks)
        for (std::size_t i = block.begin; i < block.end; ++i)
          if (reads_texture(code.instructions()[i], readers)) readers.insert(function.id);
  }
  return readers;
}

class ReturnsOf {
 public:
  ReturnsOf(const LintedCode& linted, const spirv::Function& function, const KnownValues& values,
            const std::set<spirv::Id>& readers)
      : linted_(linted),
        function_(function),
        values_(values),
        readers_(readers),
        flow_(control_flow(linted.code, function)) {}

  // `large` means that the size of the function's result makes every condition around a return a branch.
  std::vector<hlsl::Diagnostic> findings(bool large) const {
    std::vector<hlsl::Diagnostic> findings;
    std::set<std::size_t>
        setting;  // conditions around returns that FXC turns into a choice: the result is set behind them
    for (const std::size_t node : flow_.order) {
      const spirv::Instruction& end = terminator(linted_.code, function_.blocks[node]);
      if (end.op != spv::OpReturnValue) continue;
      if (!is_early(node, large))
        setting.insert(condition_around(node));
      else if (!is_behind(setting, node))
        findings.push_back(finding_of(end));
    }
    return findings;
  }

 private:
  // Returns the innermost condition; without one, the function's first block.
  std::size_t condition_around(std::size_t node) const {
    std::size_t at = node;
    while (flow_.dominator[at] != at) {
      at = flow_.dominator[at];
      if (flow_.encloses(at, node)) break;
    }
    return at;
  }

  bool is_behind(const std::set<std::size_t>& conditions, std::size_t node) const {
    for (std::size_t at = node; flow_.dominator[at] != at;) {
      at = flow_.dominator[at];
      if (conditions.contains(at) && !flow_.encloses(at, node)) return true;
    }
    return false;
  }

  // Returns whether FXC makes a branch of a condition around the return, from the innermost to the outermost,
  // with code behind it and outside of loops.
  bool is_early(std::size_t returns, bool large) const {
    bool early = false;
    for (std::size_t at = returns; flow_.dominator[at] != at;) {
      at = flow_.dominator[at];
      if (!flow_.encloses(at, returns)) continue;
      if (merge_instruction(linted_.code, function_.blocks[at]).op == spv::OpLoopMerge) {
        early = false;
      } else {
        early = early || leaves_result_unset(at, large);
      }
    }
    return early;
  }

  bool leaves_result_unset(std::size_t header, bool large) const {
    const spirv::Instruction& branch = terminator(linted_.code, function_.blocks[header]);
    if (branch.op != spv::OpBranchConditional || flow_.successors[header].size() < 2 ||
        !flow_.reachable(flow_.merge[header]))
      return false;
    const std::uint32_t control = merge_instruction(linted_.code, function_.blocks[header]).operands[1];
    if ((control & spv::SelectionControlFlattenMask) != 0) return false;
    const bool branches = large || (control & spv::SelectionControlDontFlattenMask) != 0;
    return (branches || encloses_texture_read(header)) && !values_.known(branch.operands[0]);
  }

  bool encloses_texture_read(std::size_t header) const {
    const auto first = linted_.code.instructions().begin();
    return std::any_of(flow_.order.begin(), flow_.order.end(), [&](std::size_t node) {
      const spirv::Block& block = function_.blocks[node];
      return flow_.encloses(header, node) && std::any_of(first + static_cast<std::ptrdiff_t>(block.begin),
                                                         first + static_cast<std::ptrdiff_t>(block.end),
                                                         [this](const spirv::Instruction& instruction) {
                                                           return reads_texture(instruction, readers_);
                                                         });
    });
  }

  hlsl::Diagnostic finding_of(const spirv::Instruction& at) const {
    std::string name = linted_.code.name(function_.id);
    name = name.substr(0, name.find('('));
    return finding_at(linted_, "early-return", at.place, {"return"},
                      "FXC, Unity's compiler, takes the result of '" + name +
                          "' for uninitialised because of this return from within a condition: set a "
                          "variable on both sides of the condition, and return it at the function's end");
  }

  const LintedCode& linted_;
  const spirv::Function& function_;
  const KnownValues& values_;
  const std::set<spirv::Id>& readers_;
  const ControlFlow flow_;
};

// A helper function of one return has none that is early.
bool has_several_returns(const spirv::Code& code, const spirv::Function& function) {
  if (function.id == code.entry_function() || code.name(function.id).starts_with('@') ||
      function.blocks.size() > most_blocks)
    return false;
  return std::count_if(function.blocks.begin(), function.blocks.end(), [&](const spirv::Block& block) {
           return terminator(code, block).op == spv::OpReturnValue;
         }) > 1;
}

}  // namespace

std::vector<hlsl::Diagnostic> early_return_findings(const LintedCode& linted) {
  const spirv::Code& code = linted.code;
  const KnownValues values(code);
  const std::set<spirv::Id> readers = texture_readers(code);
  ComponentLayout layout(code);
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : code.functions()) {
    if (!has_several_returns(code, function)) continue;
    const bool large = layout.count(function.result_type) > most_chosen;
    for (hlsl::Diagnostic& finding : ReturnsOf(linted, function, values, readers).findings(large))
      findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace penumbra::lint
