#include "preparation/prepare.h"

#include <array>

#include "preparation/precision_twins.h"
#include "preparation/stray_semicolons.h"
#include "preparation/texture_precision.h"

namespace penumbra::preparation {

std::span<const Pass> passes() {
  static constexpr std::array<Pass, 3> all{{{"texture-precision", drop_texture_precision},
                                            {"precision-twins", merge_precision_twins},
                                            {"stray-semicolons", drop_stray_semicolons}}};
  return all;
}

PreparedShader prepare(std::string preprocessed, const std::string& main_file) {
  TokenText text(std::move(preprocessed), main_file);
  for (const Pass& pass : passes()) pass.run(text);
  return {text.print(), text.notes()};
}

}  // namespace penumbra::preparation
