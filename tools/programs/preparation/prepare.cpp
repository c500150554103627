#include "preparation/prepare.h"

#include <array>

#include "preparation/passes.h"

namespace penumbra::preparation {

std::span<const Pass> passes() {
  static constexpr std::array<Pass, 21> all{{{"matrix-packing", pack_matrices},
                                             {"constant-uniforms", make_constants_uniforms},
                                             {"uniform-parameters", drop_uniform_of_parameters},
                                             {"texture-precision", drop_texture_precision},
                                             {"precision-matrices", name_precision_matrices},
                                             {"storage-order", put_static_first},
                                             {"plain-registers", plain_registers},
                                             {"cbuffer-resources", move_out_of_cbuffers},
                                             {"dx9-samplers", separate_dx9_samplers},
                                             {"buffer-aliases", resolve_buffer_aliases},
                                             {"texture-reads", separate_texture_reads},
                                             {"missing-returns", return_from_empty_functions},
                                             {"precision-overloads", merge_precision_overloads},
                                             {"narrower-parameters", narrow_arguments},
                                             {"stray-semicolons", drop_stray_semicolons},
                                             {"statement-attributes", drop_statement_attributes},
                                             {"matrix-casts", widen_matrix_casts},
                                             {"matrix-swizzles", write_out_matrix_swizzles},
                                             {"intrinsic-definitions", define_intrinsics},
                                             {"constant-operands", hide_constant_operands},
                                             {"uniform-writes", copy_written_uniforms}}};
  return all;
}

PreparedShader prepare(std::string preprocessed, const std::string& main_file,
                       const std::optional<EntryPoint>& entry) {
  TokenText text(std::move(preprocessed), main_file);
  if (!check_nesting(text) || !check_struct_sizes(text)) return {{}, text.notes()};
  std::vector<SemanticPlace> semantics;
  if (entry) {
    text.set_entry(entry->name);
    semantics = read_entry_semantics(text, *entry);
  }
  for (const Pass& pass : passes()) pass.run(text);
  return {text.print(), text.notes(), std::move(semantics)};
}

}  // namespace penumbra::preparation
