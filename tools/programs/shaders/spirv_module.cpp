#include "shaders/spirv_module.h"

#include <map>
#include <set>

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include "shaders/debug_lines.h"
#include "shaders/word_blocks.h"
#include "spirv/words.h"

namespace penumbra::shaders {

namespace {

spv_target_env environment(VulkanVersion vulkan) {
  switch (vulkan) {
    case VulkanVersion::v1_0:
      return SPV_ENV_VULKAN_1_0;
    case VulkanVersion::v1_1:
      break;
    case VulkanVersion::v1_2:
      return SPV_ENV_VULKAN_1_2;
  }
  return SPV_ENV_VULKAN_1_1;
}

// Returns "GroupNonUniform" for the capability of that number; empty for none.
std::string capability_name(std::uint32_t number) {
  const SpirvModule module{0x07230203, 0x00010600, 0, 1, 0, 0x00020011, number};
  std::string text;
  const spvtools::SpirvTools tools(SPV_ENV_UNIVERSAL_1_6);
  if (!tools.Disassemble(module, &text, SPV_BINARY_TO_TEXT_OPTION_NO_HEADER)) return {};
  return text.substr(text.find(' ') + 1, text.find('\n') - text.find(' ') - 1);
}

// SPIRV-Tools reports a capability that the version does not define by its number.
std::string with_capability_name(const std::string& message) {
  constexpr std::string_view unknown = "Invalid capability operand: ";
  if (!message.starts_with(unknown)) return message;
  const std::string number = message.substr(unknown.size());
  const bool is_number =
      !number.empty() && number.size() < 10 && number.find_first_not_of("0123456789") == std::string::npos;
  const std::string name = is_number ? capability_name(static_cast<std::uint32_t>(std::stoul(number))) : "";
  return name.empty() ? message : "there is no capability " + name;
}

spvtools::MessageConsumer collect_errors(std::vector<std::string>& problems) {
  return [&problems](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
    if (level <= SPV_MSG_ERROR) problems.push_back(with_capability_name(message));
  };
}

// The effect of RegisterLegalizationPasses() on HLSL, but each pass of it and of RegisterPerformancePasses()
// only runs where it still changes Unity's shaders: the same result in half the time. Code that inlining
// leaves unused is removed before scalar replacement of structs, which saves an eighth of the rest.
void legalise(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateWrapOpKillPass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateMergeReturnPass())
      .RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreatePrivateToLocalPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass(false))
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateSimplificationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass(false))
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateCCPPass());
}

void optimise_legalised(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateLoopUnrollPass(true))
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateCopyPropagateArraysPass())
      .RegisterPass(spvtools::CreateVectorDCEPass())
      .RegisterPass(spvtools::CreateDeadInsertElimPass())
      .RegisterPass(spvtools::CreateReduceLoadSizePass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateBlockMergePass())
      .RegisterPass(spvtools::CreateRedundancyEliminationPass())
      .RegisterPass(spvtools::CreateIfConversionPass())
      .RegisterPass(spvtools::CreateSimplificationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateBlockMergePass())
      .RegisterPass(spvtools::CreateInterpolateFixupPass());
}

bool run_passes(SpirvModule& module, VulkanVersion vulkan, void (*passes)(spvtools::Optimizer&),
                std::vector<std::string>& problems) {
  spvtools::Optimizer optimizer(environment(vulkan));
  optimizer.SetMessageConsumer(collect_errors(problems));
  passes(optimizer);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  return optimizer.Run(module.data(), module.size(), &module, options);
}

// Returns the number of the instruction (1 is the first after the header) for which SPIRV-Tools reports the
// first problem.
std::optional<std::size_t> problem_instruction(const SpirvModule& module, VulkanVersion vulkan) {
  std::optional<std::size_t> found;
  spvtools::SpirvTools tools(environment(vulkan));
  tools.SetMessageConsumer(
      [&found](spv_message_level_t level, const char*, const spv_position_t& position, const char*) {
        if (level <= SPV_MSG_ERROR && !found && position.index != 0) found = position.index;
      });
  tools.Validate(module.data(), module.size(), spvtools::ValidatorOptions());
  return found;
}

SourcePlace place_of_instruction(const SpirvModule& module, std::size_t wanted) {
  DebugLines lines;
  SourcePlace found;
  std::size_t number = 0;
  spirv::for_each_instruction(module, [&](spirv::Words instruction) {
    const SourcePlace& place = lines.visit(instruction);
    if (++number == wanted) found = place;
  });
  return found;
}

// Visits the decorations of variables that have one number.
template <typename Visit>
void for_each_decoration(SpirvModule& module, spv::Decoration decoration, Visit visit) {
  spirv::for_each_instruction(module, [&](spirv::WrittenWords instruction) {
    if (spirv::opcode(instruction) == spv::OpDecorate && instruction.size() == 4 &&
        instruction[2] == decoration)
      visit(instruction[3]);
  });
}

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

void number_bindings(SpirvModule& module) {
  std::uint32_t next = 0;
  for_each_decoration(module, spv::DecorationBinding, [&](std::uint32_t& binding) { binding = next++; });
}

void move_sets(SpirvModule& module, std::uint32_t by) {
  for_each_decoration(module, spv::DecorationDescriptorSet, [&](std::uint32_t& set) { set += by; });
}

bool optimise(SpirvModule& module, VulkanVersion vulkan, std::vector<std::string>& problems,
              SpirvModule* legalised) {
  if (!run_passes(module, vulkan, legalise, problems)) return false;
  if (legalised != nullptr) *legalised = module;
  return run_passes(module, vulkan, optimise_legalised, problems);
}

bool finish(SpirvModule& module, VulkanVersion vulkan, std::vector<std::string>& problems,
            SpirvModule* legalised) {
  if (!optimise(module, vulkan, problems, legalised)) return false;
  number_bindings(module);
  if (std::optional<SpirvModule> words = with_word_blocks(module, BlocksAsWords::not_for_vulkan))
    module = *std::move(words);
  return true;
}

std::vector<std::string> validation_problems(const SpirvModule& module, VulkanVersion vulkan,
                                             bool before_legalisation) {
  std::vector<std::string> problems;
  spvtools::SpirvTools tools(environment(vulkan));
  tools.SetMessageConsumer(collect_errors(problems));
  spvtools::ValidatorOptions options;
  options.SetBeforeHlslLegalization(before_legalisation);
  const bool valid = tools.Validate(module.data(), module.size(), options);
  if (!valid && problems.empty()) problems.emplace_back("the module is not valid");
  return problems;
}

hlsl::Diagnostic error_at(const SourcePlace& place, std::string message) {
  return {place.file, place.line, 0, hlsl::Severity::error, std::move(message), {}};
}

SourcePlace problem_place(const SpirvModule& module, VulkanVersion vulkan) {
  const std::optional<std::size_t> instruction = problem_instruction(module, vulkan);
  return instruction ? place_of_instruction(module, *instruction) : SourcePlace{};
}

void initialise_tables(SpirvModule& module) {
  if (module.size() < spirv::header_words) return;
  module = ConstantTables(module).initialised(module);
}

}  // namespace penumbra::shaders
