#include "shaders/constant_tables.h"

#include <algorithm>
#include <map>
#include <set>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

class ConstantTables {
 public:
  explicit ConstantTables(const SpirvModule& module) {
    spirv::for_each_instruction(module, [&](spirv::Words words) { find(words); });
  }

  SpirvModule initialised(const SpirvModule& module) const {
    SpirvModule result(module.begin(), module.begin() + spirv::header_words);
    const bool whole = spirv::for_each_instruction(module, [&](spirv::Words words) {
      const spv::Op op = spirv::opcode(words);
      if (op == spv::OpStore && contents_.contains(words[1])) return;
      if (op == spv::OpVariable && contents_.contains(words[2])) {
        result.insert(result.end(),
                      {5U << 16U | spv::OpVariable, words[1], words[2], words[3], contents_.at(words[2])});
        return;
      }
      result.insert(result.end(), words.begin(), words.end());
    });
    return whole ? result : module;
  }

 private:
  void find(spirv::Words words) {
    switch (spirv::opcode(words)) {
      case spv::OpConstant:
      case spv::OpConstantTrue:
      case spv::OpConstantFalse:
      case spv::OpConstantComposite:
      case spv::OpConstantNull:
        constants_.insert(words[2]);
        return;
      case spv::OpName:
      case spv::OpDecorate:
        return;
      case spv::OpVariable:
        if (words[3] == spv::StorageClassFunction && words.size() == 4) local_.insert(words[2]);
        return;
      case spv::OpStore:
        store(words[1], words[2]);
        return;
      case spv::OpLoad:
        return;
      case spv::OpAccessChain:
      case spv::OpInBoundsAccessChain:
        if (const std::uint32_t variable = variable_of(words[3]); local_.contains(variable))
          parts_[words[2]] = variable;
        return;
      default:
        refuse(words.subspan(1));
        return;
    }
  }

  void store(std::uint32_t variable, std::uint32_t value) {
    refuse(value);  // a pointer may be stored
    if (!local_.contains(variable) || !constants_.contains(value)) return refuse(variable);
    const auto [known, is_new] = contents_.emplace(variable, value);
    if (!is_new && known->second != value) refuse(variable);
  }

  // Refuses a word that may be a variable, or a part of one, in an instruction that does not merely read it.
  // Literals that look like an id only cost the variable its initialiser.
  void refuse(std::uint32_t word) {
    const std::uint32_t variable = variable_of(word);
    local_.erase(variable);
    contents_.erase(variable);
  }

  void refuse(spirv::Words words) {
    for (const std::uint32_t word : words) refuse(word);
  }

  std::uint32_t variable_of(std::uint32_t pointer) const {
    const auto part = parts_.find(pointer);
    return part == parts_.end() ? pointer : part->second;
  }

  std::set<std::uint32_t> constants_;
  std::set<std::uint32_t> local_;                    // local variables that may still be tables
  std::map<std::uint32_t, std::uint32_t> parts_;     // the local variable of each pointer into one
  std::map<std::uint32_t, std::uint32_t> contents_;  // the constant that each local variable holds
};

}  // namespace

void initialise_tables(SpirvModule& module) {
  if (module.size() < spirv::header_words) return;
  module = ConstantTables(module).initialised(module);
}

}  // namespace penumbra::shaders
