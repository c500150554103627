// Divergence analysis: the values of a shader that differ between the pixels of a quad, or the threads of a
// group, and the blocks in divergent control flow. Internal to this folder.
//
// Source: Coutinho, Sampaio, Pereira and Meira, "Divergence Analysis and Optimizations" (2011). Values are
// divergent at their sources (interpolated inputs, atomics, calls that could not be inlined), if they depend
// on divergent values (data dependence), if a divergent branch controls them (sync dependence), and after a
// loop with a divergent number of iterations (temporal divergence). Flat inputs are uniform within a quad,
// which lies in one primitive (SPIR-V specification, "derivative group"). In a group of threads, a value that
// all of them read at one place of shared memory, a buffer or texture is uniform, as for Direct3D's compiler:
// published shaders leave loops by such values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lint/control_flow.h"
#include "lint/source_place.h"
#include "spirv/code.h"

namespace penumbra::lint {

// The invocations that run together: a fragment's quad or a compute shader's group.
enum class Together { quad, group };

class Divergence {
 public:
  // `function` is one of a legalised module of at most most_blocks blocks.
  Divergence(const spirv::Code& code, const spirv::Function& function, Together together);

  bool varies(spirv::Id value) const { return value < varies_.size() && varies_[value]; }

  // Returns the branches on varying conditions that decide whether a node runs, directly or through other
  // branches.
  std::vector<std::size_t> varying_branches_over(std::size_t node) const;

  // Returns the header of the innermost loop that has both nodes and that `branch` may leave; no_node for
  // none.
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
  std::vector<std::size_t> node_of_;  // for each id: the node that defines its value
  std::vector<bool> varies_;          // for each id; for a variable it means its contents
  std::vector<bool> branch_varies_;   // for each node: it ends in a branch on a varying value
  std::vector<bool> runs_apart_;      // for each node: some varying branch decides whether it runs
};

// Returns whether the threads of a group wait for each other there.
bool is_barrier(const spirv::Instruction& instruction);

// Returns the place of the condition on which the block branches (place_in_words).
std::string place_of_condition(const LintedCode& linted, const spirv::Function& function, std::size_t branch,
                               spirv::Place from);

// Returns the nodes of the natural loop with this header; empty if it is not one.
std::vector<bool> loop_body(const ControlFlow& flow, std::size_t header);

}  // namespace penumbra::lint
