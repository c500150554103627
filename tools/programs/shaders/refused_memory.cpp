#include "shaders/refused_memory.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "shaders/module_search.h"
#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

bool is_atomic(spv::Op op) {
  return op >= spv::OpAtomicLoad && op <= spv::OpAtomicXor;
}

// Returns the index of the pointer operand in an instruction that reads or writes memory; 0 for others.
std::size_t pointer_word(spv::Op op) {
  if (op == spv::OpStore || op == spv::OpAtomicStore) return 1;
  return is_atomic(op) || op == spv::OpLoad || op == spv::OpAccessChain || op == spv::OpInBoundsAccessChain
             ? 3
             : 0;
}

class MemorySearch final : public ModuleSearch {
 public:
  MemorySearch(const SpirvModule& module, hlsl::Stage stage) : ModuleSearch(module), stage_(stage) {}

 private:
  void visit(spirv::Words instruction) override {
    const spv::Op op = spirv::opcode(instruction);
    note_read_only(op, instruction);
    if (op == spv::OpTypePointer && instruction.size() > 2) classes_[instruction[1]] = instruction[2];
    if (const std::size_t at = pointer_word(op); at != 0 && instruction.size() > at)
      use(op, class_of(instruction[at]));
    const bool makes_pointer = op == spv::OpVariable || op == spv::OpAccessChain ||
                               op == spv::OpInBoundsAccessChain || op == spv::OpCopyObject;
    if (makes_pointer && instruction.size() > 2) classes_[instruction[2]] = class_of(instruction[1]);
  }

  // Records buffers whose struct has members that may not be written, and the variables behind pointers into
  // them.
  void note_read_only(spv::Op op, spirv::Words instruction) {
    if (op == spv::OpMemberDecorate && instruction.size() > 3 && instruction[3] == spv::DecorationNonWritable)
      read_only_.insert(instruction[1]);
    if (op == spv::OpTypePointer && instruction.size() > 3 && read_only_.contains(instruction[3]))
      read_only_.insert(instruction[1]);
    if (op == spv::OpVariable && instruction.size() > 2 && read_only_.contains(instruction[1]))
      read_only_.insert(instruction[2]);
    const bool part = op == spv::OpAccessChain || op == spv::OpInBoundsAccessChain || op == spv::OpCopyObject;
    if (part && instruction.size() > 3 && read_only_.contains(instruction[3]))
      read_only_.insert(instruction[2]);
    if (is_atomic(op) && op != spv::OpAtomicLoad && pointer_word(op) < instruction.size() &&
        read_only_.contains(instruction[pointer_word(op)]))
      report("an Interlocked function changes a buffer that can only be read: declare it as an RW buffer");
  }

  // Returns the storage class of a pointer's type, or of a pointer.
  std::uint32_t class_of(std::uint32_t id) const {
    const auto found = classes_.find(id);
    return found == classes_.end() ? std::uint32_t{spv::StorageClassMax} : found->second;
  }

  void use(spv::Op op, std::uint32_t storage) {
    if (storage == spv::StorageClassWorkgroup && stage_ != hlsl::Stage::compute)
      report(std::string("a groupshared variable is used in a ") + hlsl::stage_name(stage_) +
             " program: only compute programs have them");
    if (is_atomic(op) && (storage == spv::StorageClassFunction || storage == spv::StorageClassPrivate))
      report(
          "an Interlocked function changes a local variable: it takes groupshared variables and elements "
          "of RW resources");
  }

  hlsl::Stage stage_;
  std::set<std::uint32_t> read_only_;               // structs, pointer types, variables and pointers
  std::map<std::uint32_t, std::uint32_t> classes_;  // storage class of each pointer and type of pointers
};

}  // namespace

std::vector<hlsl::Diagnostic> refused_memory(const SpirvModule& module, hlsl::Stage stage) {
  return MemorySearch(module, stage).run();
}

}  // namespace penumbra::shaders
