#include "lint/legalised.h"

#include <spirv-tools/optimizer.hpp>

namespace penumbra::lint {

namespace {

void legalise(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateMergeReturnPass())
      .RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreatePrivateToLocalPass())
      .RegisterPass(spvtools::CreateFixStorageClassPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())  // or access chains without use hold variables back
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateCCPPass());
}

void simplify(spvtools::Optimizer& to) {
  to.RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateSimplificationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateCopyPropagateArraysPass())
      .RegisterPass(spvtools::CreateVectorDCEPass())
      .RegisterPass(spvtools::CreateDeadInsertElimPass())
      .RegisterPass(spvtools::CreateRedundancyEliminationPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
}

std::optional<std::vector<std::uint32_t>> run(const spvtools::Optimizer& optimizer,
                                              const std::vector<std::uint32_t>& spirv) {
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(spirv.data(), spirv.size(), &words, options)) return std::nullopt;
  return words;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
  legalise(optimizer);
  simplify(optimizer);
  return run(optimizer, spirv);
}

std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& spirv) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
  simplify(optimizer);
  return run(optimizer, spirv);
}

}  // namespace penumbra::lint
