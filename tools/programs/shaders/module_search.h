// A traversal of a module's instructions that reports problems, each once and at its line. Internal to this
// folder.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "shaders/debug_lines.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

class ModuleSearch {
 public:
  explicit ModuleSearch(const SpirvModule& module) : module_(module) {}
  virtual ~ModuleSearch() = default;
  ModuleSearch(const ModuleSearch&) = delete;
  ModuleSearch& operator=(const ModuleSearch&) = delete;

  std::vector<hlsl::Diagnostic> run() {
    spirv::for_each_instruction(module_, [this](spirv::Words instruction) {
      place_ = lines_.visit(instruction);
      visit(instruction);
    });
    return std::move(problems_);
  }

 protected:
  virtual void visit(spirv::Words instruction) = 0;

  // Reports a problem of the current instruction.
  void report(std::string message) {
    hlsl::Diagnostic problem = error_at(place_, std::move(message));
    if (std::find(problems_.begin(), problems_.end(), problem) == problems_.end())
      problems_.push_back(std::move(problem));
  }

 private:
  const SpirvModule& module_;
  DebugLines lines_;
  SourcePlace place_;
  std::vector<hlsl::Diagnostic> problems_;
};

}  // namespace penumbra::shaders
