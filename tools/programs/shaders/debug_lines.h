// The source line of each instruction, in a module with debug lines. Internal to this folder.
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

// OpLine applies up to the next one, or to the end of the block (SPIR-V specification, 3.52.3).
class DebugLines {
 public:
  // Must be called for every instruction in order; returns its location.
  const SourcePlace& visit(spirv::Words instruction) {
    const spv::Op op = spirv::opcode(instruction);
    if (op == spv::OpString && instruction.size() > 2)
      strings_[instruction[1]] = spirv::literal_text(instruction.subspan(2));
    if (op == spv::OpLine && instruction.size() > 2)
      place_ = {strings_[instruction[1]], static_cast<int>(instruction[2])};
    if (op == spv::OpNoLine || op == spv::OpLabel || op == spv::OpFunctionEnd) place_ = {};
    return place_;
  }

 private:
  std::map<std::uint32_t, std::string> strings_;
  SourcePlace place_;
};

// A traversal of a module's instructions that reports problems, each once and at its line.
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
