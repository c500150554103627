#include "shaders/refused_instructions.h"

#include <string>

#include "shaders/module_search.h"

namespace penumbra::shaders {

namespace {

class InstructionSearch final : public ModuleSearch {
 public:
  InstructionSearch(const SpirvModule& module, hlsl::Stage stage) : ModuleSearch(module), stage_(stage) {}

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    const bool discards =
        op == spv::OpKill || op == spv::OpTerminateInvocation || op == spv::OpDemoteToHelperInvocationEXT;
    if (discards && stage_ != hlsl::Stage::fragment)
      report("clip() and discard end a pixel, and a " + std::string(hlsl::stage_name(stage_)) +
             " program has none: only fragment programs have them");
    // The front end itself puts one into hull programs.
    if (op == spv::OpControlBarrier && stage_ != hlsl::Stage::compute && stage_ != hlsl::Stage::hull)
      report("a barrier waits for the threads of a group, and a " + std::string(hlsl::stage_name(stage_)) +
             " program has none: only compute programs have barriers with sync");
  }

  hlsl::Stage stage_;
};

}  // namespace

std::vector<hlsl::Diagnostic> refused_instructions(const SpirvModule& module, hlsl::Stage stage) {
  return InstructionSearch(module, stage).run();
}

}  // namespace penumbra::shaders
