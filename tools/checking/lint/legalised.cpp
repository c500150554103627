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
      .RegisterPass(
          spvtools::CreateAggressiveDCEPass())  // otherwise unused access chains keep variables alive
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

enum class Legalisation { done, to_do };

std::optional<std::vector<std::uint32_t>> optimised(const std::vector<std::uint32_t>& spirv,
                                                    Legalisation legalisation) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
  if (legalisation == Legalisation::to_do) legalise(optimizer);
  simplify(optimizer);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> words;
  if (!optimizer.Run(spirv.data(), spirv.size(), &words, options)) return std::nullopt;
  return words;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> legalised(const std::vector<std::uint32_t>& spirv) {
  return optimised(spirv, Legalisation::to_do);
}

std::optional<std::vector<std::uint32_t>> simplified(const std::vector<std::uint32_t>& spirv) {
  return optimised(spirv, Legalisation::done);
}

}  // namespace penumbra::lint
