#include <algorithm>
#include <string>

#include "lint/control_flow.h"
#include "lint/known_values.h"
#include "lint/stage_rules.h"

namespace penumbra::lint {

namespace {

// Returns whether the instruction stores through an index that is not a constant into a vector or matrix that
// the shader declares.
bool writes_by_index(const spirv::Code& code, const spirv::Instruction& instruction) {
  const spirv::Instruction* chain =
      instruction.op == spv::OpStore ? code.definition(instruction.operands[0]) : nullptr;
  if (chain == nullptr || chain->op != spv::OpAccessChain) return false;
  const spirv::Instruction* base = code.definition(chain->operands[0]);
  const std::optional<spv::StorageClass> storage = code.storage_class(base->type);
  if (storage != spv::StorageClassFunction && storage != spv::StorageClassPrivate) return false;
  const spirv::Instruction* type = code.definition(code.pointee(base->type));
  for (std::size_t i = 1; i < chain->operands.size() && type != nullptr; ++i) {
    const std::optional<std::int64_t> index = code.integer(chain->operands[i]);
    if (!index && (type->op == spv::OpTypeVector || type->op == spv::OpTypeMatrix)) return true;
    const bool is_struct = type->op == spv::OpTypeStruct;
    type = code.definition(type->operands[is_struct ? static_cast<std::size_t>(index.value_or(0)) : 0]);
  }
  return false;
}

class WritesOf {
 public:
  WritesOf(const LintedCode& linted, const spirv::Function& function, const KnownValues& values)
      : linted_(linted), function_(function), values_(values), flow_(control_flow(linted.code, function)) {}

  std::vector<hlsl::Diagnostic> findings() {
    for (const std::size_t node : flow_.order)
      for (std::size_t i = function_.blocks[node].begin; i < function_.blocks[node].end; ++i) {
        const spirv::Instruction& instruction = linted_.code.instructions()[i];
        if (writes_by_index(linted_.code, instruction)) look_at(instruction, node);
      }
    return std::move(findings_);
  }

 private:
  const spirv::Instruction& merge_of(std::size_t node) const {
    return merge_instruction(linted_.code, function_.blocks[node]);
  }

  std::size_t loop_of(std::size_t node) const {
    for (std::size_t at = node;; at = flow_.dominator[at]) {
      if (flow_.encloses(at, node) && merge_of(at).op == spv::OpLoopMerge) return at;
      if (flow_.dominator[at] == at) return no_node;
    }
  }

  // Returns whether a jump to the loop's next iteration, guarded by a condition that ends before the write,
  // may skip it: the compiler does not know whether the jump is taken.
  bool may_be_skipped(std::size_t write, std::size_t loop) const {
    const spirv::Id next = merge_of(loop).operands[1];
    return std::any_of(flow_.order.begin(), flow_.order.end(), [&](std::size_t node) {
      const spirv::Instruction& end = terminator(linted_.code, function_.blocks[node]);
      if (end.op != spv::OpBranch || end.operands[0] != next || loop_of(node) != loop) return false;
      bool is_before = false;
      bool unknown = false;
      for (std::size_t at = flow_.dominator[node]; at != loop; at = flow_.dominator[at]) {
        if (!flow_.encloses(at, node)) continue;
        is_before = is_before || flow_.dominates(flow_.merge[at], write);
        unknown = unknown || !values_.known(terminator(linted_.code, function_.blocks[at]).operands[0]);
      }
      return is_before && unknown;
    });
  }

  void look_at(const spirv::Instruction& write, std::size_t node) {
    const std::size_t loop = loop_of(node);
    if (loop == no_node) return;
    const bool kept = (merge_of(loop).operands[2] & spv::LoopControlDontUnrollMask) != 0;
    if (!kept && !may_be_skipped(node, loop)) return;
    const std::string name = linted_.code.name(base_of(linted_.code, write.operands[0]));
    findings_.push_back(finding_at(
        linted_, "indexed-write", write.place, {name},
        "'" + name +
            "' is written by index in a loop that FXC, Unity's compiler, cannot unroll, because of " +
            (kept ? "[loop]: write by constant index, or to an array"
                  : "the 'continue' before it: put the write into the condition in place of 'continue'")));
  }

  const LintedCode& linted_;
  const spirv::Function& function_;
  const KnownValues& values_;
  const ControlFlow flow_;
  std::vector<hlsl::Diagnostic> findings_;
};

}  // namespace

std::vector<hlsl::Diagnostic> indexed_write_findings(const LintedCode& linted) {
  const auto& all = linted.code.instructions();
  const auto writes = [&](const spirv::Instruction& any) { return writes_by_index(linted.code, any); };
  if (std::none_of(all.begin(), all.end(), writes)) return {};
  const KnownValues values(linted.code);
  std::vector<hlsl::Diagnostic> findings;
  for (const spirv::Function& function : linted.code.functions()) {
    if (function.blocks.empty() || function.blocks.size() > most_blocks) continue;
    for (hlsl::Diagnostic& finding : WritesOf(linted, function, values).findings())
      findings.push_back(std::move(finding));
  }
  return findings;
}

}  // namespace penumbra::lint
