#include "preparation/prepare.h"

#include <array>

#include "preparation/constructor_statements.h"
#include "preparation/flat_initialisers.h"
#include "preparation/intrinsic_calls.h"
#include "preparation/matrix_swizzles.h"
#include "preparation/namespace_structs.h"
#include "preparation/partial_texel_writes.h"
#include "preparation/precision_twins.h"
#include "preparation/stray_semicolons.h"
#include "preparation/texture_precision.h"
#include "preparation/uniform_writes.h"

namespace penumbra::preparation {

std::span<const Pass> passes() {
  static constexpr std::array<Pass, 10> all{{{"texture-precision", drop_texture_precision},
                                             {"precision-twins", merge_precision_twins},
                                             {"stray-semicolons", drop_stray_semicolons},
                                             {"namespace-structs", write_out_namespaces},
                                             {"flat-initialisers", group_flat_initialisers},
                                             {"partial-texel-writes", write_whole_texels},
                                             {"matrix-swizzles", write_out_matrix_swizzles},
                                             {"constructor-statements", wrap_constructor_statements},
                                             {"uniform-writes", copy_written_uniforms},
                                             {"intrinsic-calls", write_out_intrinsic_calls}}};
  return all;
}

PreparedShader prepare(std::string preprocessed, const std::string& main_file) {
  TokenText text(std::move(preprocessed), main_file);
  for (const Pass& pass : passes()) pass.run(text);
  return {text.print(), text.notes()};
}

}  // namespace penumbra::preparation
