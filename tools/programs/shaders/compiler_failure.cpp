#include "shaders/compiler_failure.h"

namespace penumbra::shaders {

CompilerFailure compiler_failure(const platform::WorkerOutcome& outcome) {
  CompilerFailure failure{"the compiler " + outcome.failure, {}, outcome.failure.starts_with("took ")};
  if (!outcome.output_tail.empty()) failure.problem += "; it said: " + outcome.output_tail;
  failure.remedy = failure.limited
                       ? "simplify the shader, or raise --time-limit and --memory-limit"
                       : "leave out parts of the shader until it compiles; `penumbra validate` keeps the "
                         "text that the compiler fails on";
  return failure;
}

}  // namespace penumbra::shaders
