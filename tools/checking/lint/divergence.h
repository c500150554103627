// Divergence analysis: which values of a shader differ between the pixels of a quad, or the threads of a
// group, and which blocks are in divergent control flow. Internal to this folder.
//
// After Coutinho, Sampaio, Pereira and Meira, "Divergence Analysis and Optimizations" (2011): values are
// divergent at their sources (interpolated inputs, atomics, calls that could not be inlined), if they depend
// on divergent values (data dependence), if a divergent branch controls them (sync dependence), and after a
// loop with a divergent number of iterations (temporal divergence). Flat inputs are uniform within a quad,
// which lies in one primitive (SPIR-V specification, "derivative group"). In a group of threads what all of
// them read at one place of shared memory, a buffer or texture is uniform, as for Direct3D's compiler:
// published shaders leave loops by such values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lint/control_flow.h"
#include "lint/source_place.h"
#include "spirv/code.h"

namespace penumbra::lint {

enum class Together { quad, group };  // what runs together: of a fragment or of a compute shader

class Divergence {
 public:
  // For a function of a legalised module. `function` must have at most most_blocks blocks.
  Divergence(const spirv::Code& code, const spirv::Function& function, Together together);

  bool varies(spirv::Id value) const { return value < varies_.size() && varies_[value]; }

  // Branches on varying conditions that decide whether a node runs, directly or through other branches.
  std::vector<std::size_t> varying_branches_over(std::size_t node) const;

  // The header of the innermost loop that has both nodes and that `branch` may leave; no_node for none.
  std::size_t loop_left_by(std::size_t branch, std::size_t node) const;

  const ControlFlow& flow() const { return flow_; }

 private:
  struct Loop {
    std::size_t header = 0;
    std::vector<bool> body;
    bool left_at_different_times = false;
  };

  void find_loops();
  void propagate();
  bool varies_at(const spirv::Instruction& instruction, std::size_t node) const;
  bool source_varies(const spirv::Instruction& instruction) const;
  bool input_varies(spirv::Id variable) const;
  bool is_own_memory(spirv::Id variable) const;
  bool phi_varies(const spirv::Instruction& phi, std::size_t node) const;
  bool used_behind_loop(const spirv::Instruction& instruction, std::size_t node) const;
  void mark_control();
  bool mark_stores();
  bool mark_loops();
  spirv::Id root(spirv::Id pointer) const;

  const spirv::Code& code_;
  const spirv::Function& function_;
  Together together_;
  ControlFlow flow_;
  Graph depends_;  // control dependence, direct
  std::vector<Loop> loops_;
  std::vector<std::size_t> node_of_;  // by id: where its value is defined
  std::vector<bool> varies_;          // by id; for a variable: its contents
  std::vector<bool> branch_varies_;   // by node: ends in a branch on a varying value
  std::vector<bool> runs_apart_;      // by node: some varying branch decides whether it runs
};

// Of the condition on which the block branches, for messages: " at line 12", " at Other.hlsl:12", seen from
// that place; empty if it is not known.
std::string place_of_condition(const LintedCode& linted, const spirv::Function& function, std::size_t branch,
                               spirv::Place from);

}  // namespace penumbra::lint
