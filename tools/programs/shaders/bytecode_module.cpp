#include "shaders/bytecode_module.h"

#include <algorithm>
#include <stdexcept>

#include "shaders/bytecode_reflection.h"
#include "shaders/module_rewrite.h"
#include "spirv/code.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

using Words = ModuleRewrite::Words;

Words text_words(const std::string& text) {
  Words words(text.size() / 4 + 1, 0);
  for (std::size_t i = 0; i < text.size(); ++i)
    words[i / 4] |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])) << (8 * (i % 4));
  return words;
}

// Gives vkd3d's module our names, and makes its buffers that are only read storage buffers, in place of
// images of one row: hosts bind them, and texels are counted, as in compile()'s modules.
class Renaming {
 public:
  Renaming(SpirvModule module, const std::vector<BytecodeResource>& resources, std::string entry)
      : module_(std::move(module)), resources_(resources), entry_(std::move(entry)), to_(module_) {}

  SpirvModule run() {
    spirv::for_each_instruction(module_, [this](spirv::Words one) { find(one); });
    spirv::for_each_instruction(module_, [this](spirv::Words one) { rewrite(one); });
    for (const auto& [variable, resource] : bound_) name(variable, *resource);
    return to_.finished();
  }

 private:
  void find(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (op == spv::OpDecorate && spirv::operand(one, 2) == spv::DecorationBinding) {
      if (spirv::operand(one, 3) >= resources_.size())
        throw std::invalid_argument("a binding that the bytecode does not declare");
      bound_[spirv::operand(one, 1)] = &resources_[spirv::operand(one, 3)];
    }
    if (op == spv::OpTypePointer) pointees_[spirv::operand(one, 1)] = spirv::operand(one, 3);
    if (op == spv::OpVariable) types_[spirv::operand(one, 2)] = pointees_[spirv::operand(one, 1)];
  }

  const BytecodeResource* read_buffer(std::uint32_t variable) const {
    const auto found = bound_.find(variable);
    const bool is = found != bound_.end() && found->second->registers == RegisterKind::texture &&
                    found->second->resource.kind == ResourceKind::storage_buffer;
    return is ? found->second : nullptr;
  }

  void rewrite(spirv::Words one) {
    const spv::Op op = spirv::opcode(one);
    if (op == spv::OpName || op == spv::OpMemberName) return;
    // vkd3d decorates a type once for each buffer that has it.
    const bool decorates = op == spv::OpDecorate || op == spv::OpMemberDecorate;
    if (decorates && !decorations_.emplace(one.begin(), one.end()).second) return;
    if (op == spv::OpEntryPoint) return keep_entry_point(one);
    if (op == spv::OpVariable && read_buffer(spirv::operand(one, 2)) != nullptr) return;
    if (op == spv::OpFunction && !declared_) declare_buffers();
    if (op == spv::OpLoad && read_buffer(spirv::operand(one, 3)) != nullptr) {
      loaded_[spirv::operand(one, 2)] = spirv::operand(one, 3);
      return;
    }
    const auto buffer = loaded_.find(spirv::operand(one, 3));
    if (op >= spv::OpSampledImage && op <= spv::OpImageQuerySamples && buffer != loaded_.end()) {
      if (op != spv::OpImageFetch)
        throw std::invalid_argument("the size of a buffer, which is not run from bytecode");
      return fetch(one, buffer->second);
    }
    to_.keep(one);
  }

  void keep_entry_point(spirv::Words one) {
    Words words(one.begin(), one.begin() + 3);
    const Words named = text_words(entry_);
    words.insert(words.end(), named.begin(), named.end());
    const std::size_t before = spirv::literal_text(one.subspan(3)).size() / 4 + 1;
    words.insert(words.end(), one.begin() + static_cast<std::ptrdiff_t>(3 + before), one.end());
    words[0] = static_cast<std::uint32_t>(words.size() << 16U) | spv::OpEntryPoint;
    to_.keep(words);
  }

  // vkd3d writes SPIR-V 1.0, where a storage buffer is a block of the Uniform class.
  void declare_buffers() {
    declared_ = true;
    for (const auto& [variable, resource] : bound_) {
      if (read_buffer(variable) == nullptr || types_.find(variable) == types_.end()) continue;
      const std::uint32_t words = to_.new_type(spv::OpTypeRuntimeArray, {to_.uint_type()});
      const std::uint32_t block = to_.new_type(spv::OpTypeStruct, {words});
      to_.decoration(spv::OpDecorate, {words, spv::DecorationArrayStride, 4});
      to_.decoration(spv::OpMemberDecorate, {block, 0, spv::DecorationOffset, 0});
      to_.decoration(spv::OpMemberDecorate, {block, 0, spv::DecorationNonWritable});
      to_.decoration(spv::OpDecorate, {block, spv::DecorationBufferBlock});
      const std::uint32_t pointer = to_.type(spv::OpTypePointer, {spv::StorageClassUniform, block});
      to_.global(spv::OpVariable, {pointer, variable, spv::StorageClassUniform});
    }
  }

  // A texel of such an image is a word in x.
  void fetch(spirv::Words one, std::uint32_t variable) {
    const std::uint32_t uint = to_.uint_type();
    const std::uint32_t pointer = to_.type(spv::OpTypePointer, {spv::StorageClassUniform, uint});
    const std::uint32_t place =
        to_.result(spv::OpAccessChain, pointer, {variable, to_.uint_constant(0), spirv::operand(one, 4)});
    const std::uint32_t word = to_.result(spv::OpLoad, uint, {place});
    to_.result(spv::OpCompositeConstruct, spirv::operand(one, 1), {word, word, word, word},
               spirv::operand(one, 2));
  }

  // reflect() reads the name of a block from its type.
  void name(std::uint32_t variable, const BytecodeResource& resource) {
    const auto type = types_.find(variable);
    if (type == types_.end()) return;
    const bool block = resource.registers == RegisterKind::constants;
    Words words{block ? type->second : variable};
    const Words named = text_words(resource.resource.name);
    words.insert(words.end(), named.begin(), named.end());
    to_.name(spv::OpName, words);
  }

  const SpirvModule module_;
  const std::vector<BytecodeResource>& resources_;
  const std::string entry_;
  ModuleRewrite to_;
  std::map<std::uint32_t, const BytecodeResource*> bound_;  // by variable
  // The pointee of each pointer type, and the type of each variable's content.
  std::map<std::uint32_t, std::uint32_t> pointees_, types_;
  std::map<std::uint32_t, std::uint32_t> loaded_;  // variables, by what was loaded from them
  std::set<Words> decorations_;
  bool declared_ = false;
};

void require_valid(const SpirvModule& module) {
  const std::vector<std::string> problems = validation_problems(module, VulkanVersion::v1_1, false);
  if (!problems.empty())
    throw std::invalid_argument("vkd3d-shader translates the bytecode into a module that is not valid: " +
                                problems.front());
}

using spirv::Id;
using spirv::Instruction;

class StepFinder {
 public:
  explicit StepFinder(const spirv::Code& code) : code_(code) {}

  // The search runs from the last instruction, so that all uses of a result are known before it.
  std::set<Id> run() {
    const std::vector<Instruction>& all = code_.instructions();
    for (auto one = all.rbegin(); one != all.rend(); ++one) {
      const bool is = is_step(*one);
      if (is) steps_.insert(one->result);
      use_operands(*one, is);
    }
    return std::move(steps_);
  }

 private:
  bool is_step(const Instruction& one) const {
    switch (one.op) {
      case spv::OpSelect:
        return makes_mask(one);
      case spv::OpINotEqual:  // it is the program's own if no mask is made of it
        return is_constant(one.operands[1], 0) && !masked_.contains(one.result);
      case spv::OpIAdd:
      case spv::OpIMul:
      case spv::OpShiftRightLogical:
      case spv::OpBitwiseAnd:
        return addresses_.contains(one.result) && !kept_.contains(one.result);
      default:
        return false;
    }
  }

  void use_operands(const Instruction& one, bool is_a_step) {
    if (one.op == spv::OpSelect && makes_mask(one)) masked_.insert(one.operands[0]);
    const bool chain = one.op == spv::OpAccessChain || one.op == spv::OpInBoundsAccessChain;
    const bool shift = one.op >= spv::OpShiftRightLogical && one.op <= spv::OpShiftLeftLogical;
    for (std::size_t i = 0; i < code_.ids(one).size(); ++i) {
      const Id id = code_.ids(one)[i];
      const bool of_address = is_a_step || (chain && i > 0) || (shift && i == 1);
      (of_address ? addresses_ : kept_).insert(id);
    }
  }

  bool makes_mask(const Instruction& select) const {
    return is_constant(select.operands[1], 0xFFFFFFFFU) && is_constant(select.operands[2], 0);
  }

  // Every component of a vector must have the value.
  bool is_constant(Id id, std::uint32_t value) const {
    const Instruction* definition = code_.definition(id);
    if (definition == nullptr) return false;
    if (definition->op == spv::OpConstant) return definition->operands[0] == value;
    return definition->op == spv::OpConstantComposite &&
           std::all_of(definition->operands.begin(), definition->operands.end(),
                       [&](Id component) { return is_constant(component, value); });
  }

  const spirv::Code& code_;
  std::set<Id> steps_;
  std::set<Id> masked_;            // conditions that become masks
  std::set<Id> addresses_, kept_;  // used in an address or a shift's number, and otherwise
};

}  // namespace

BytecodeModule bytecode_module(const std::string& bytecode, const std::string& entry) {
  const std::vector<BytecodeResource> resources = bytecode_resources(bytecode);
  BytecodeModule made;
  made.untouched = Renaming(translated_bytecode(bytecode, resources), resources, entry).run();
  require_valid(made.untouched);
  made.spirv = made.untouched;
  std::vector<std::string> problems;
  if (!finish(made.spirv, VulkanVersion::v1_1, problems))
    throw std::invalid_argument("the translated bytecode cannot be optimised: " + problems.front());
  require_valid(made.spirv);
  made.signature = bytecode_signature(bytecode);
  return made;
}

std::vector<Resource> bytecode_uniforms(const std::string& bytecode) {
  std::vector<Resource> blocks;
  for (BytecodeResource& resource : bytecode_resources(bytecode))
    if (resource.registers == RegisterKind::constants) blocks.push_back(std::move(resource.resource));
  return blocks;
}

std::set<Id> translation_steps(const spirv::Module& untouched) {
  const spirv::Code code(untouched);
  return StepFinder(code).run();
}

}  // namespace penumbra::shaders
