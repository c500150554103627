#include "preparation/prepare.h"

#include <array>

#include "preparation/passes.h"

namespace penumbra::preparation {

std::span<const Pass> passes() {
  static constexpr std::array<Pass, 51> all{{{"matrix-packing", pack_matrices},
                                             {"constant-uniforms", make_constants_uniforms},
                                             {"unsigned-types", name_unsigned_types},
                                             {"const-casts", drop_const_of_casts},
                                             {"uniform-parameters", drop_uniform_of_parameters},
                                             {"texture-precision", drop_texture_precision},
                                             {"precision-matrices", name_precision_matrices},
                                             {"method-bodies", put_bodies_into_structs},
                                             {"namespace-structs", write_out_namespaces},
                                             {"storage-order", put_static_first},
                                             {"type-semantics", rename_type_semantics},
                                             {"interface-types", pass_bools_as_numbers},
                                             {"base-members", write_out_base_members},
                                             {"prototypes", match_prototypes},
                                             {"own-methods", call_own_methods_by_this},
                                             {"loop-variables", keep_loop_variables},
                                             {"row-matrices", make_row_matrices_vectors},
                                             {"plain-registers", plain_registers},
                                             {"framebuffer-fetch", read_framebuffer},
                                             {"uniform-structs", take_apart_uniform_structs},
                                             {"cbuffer-resources", hoist_cbuffer_resources},
                                             {"cbuffer-offsets", place_cbuffer_members},
                                             {"dx9-samplers", separate_dx9_samplers},
                                             {"member-calls", call_members_on_variables},
                                             {"buffer-aliases", resolve_buffer_aliases},
                                             {"zeroed-resource-structs", zero_resource_structs},
                                             {"array-casts", cast_zero_to_structs},
                                             {"struct-casts", copy_cast_structs},
                                             {"resource-arrays", assign_resource_arrays},
                                             {"texture-reads", separate_texture_reads},
                                             {"missing-returns", return_from_empty_functions},
                                             {"precision-overloads", merge_precision_overloads},
                                             {"narrower-parameters", narrow_arguments},
                                             {"stray-semicolons", drop_stray_semicolons},
                                             {"statement-attributes", drop_statement_attributes},
                                             {"struct-initialisers", match_struct_initialisers},
                                             {"flat-initialisers", group_flat_initialisers},
                                             {"partial-texel-writes", write_whole_texels},
                                             {"matrix-casts", widen_matrix_casts},
                                             {"switch-values", cast_switch_values},
                                             {"swizzle-arguments", pass_swizzles_in_variables},
                                             {"matrix-swizzles", write_out_matrix_swizzles},
                                             {"matrix-operators", write_out_matrix_operators},
                                             {"integer-products", write_out_integer_products},
                                             {"intrinsic-definitions", define_intrinsics},
                                             {"constant-operands", hide_constant_operands},
                                             {"static-initialisers", work_out_static_initialisers},
                                             {"constructor-statements", wrap_constructor_statements},
                                             {"uniform-writes", copy_written_uniforms},
                                             {"bool-signs", multiply_bool_signs},
                                             {"intrinsic-calls", write_out_intrinsic_calls}}};
  return all;
}

PreparedShader prepare(std::string preprocessed, const std::string& main_file,
                       const std::optional<EntryPoint>& entry) {
  TokenText text(std::move(preprocessed), main_file);
  if (!check_nesting(text) || !check_struct_sizes(text)) return {{}, text.notes()};
  std::vector<SemanticPlace> semantics;
  if (entry) {
    text.set_entry(entry->name);
    check_semicolons(text);
    check_interfaces(text);
    check_static_members(text);
    check_resource_calls(text);
    check_thread_group(text, *entry);
    check_stage_attributes(text, *entry);
    semantics = check_entry_semantics(text, *entry);
    if (!entry->dxc) check_switch_cases(text);
    check_constant_divisions(text);
    check_initialiser_counts(text);
    check_constructor_counts(text);
    check_struct_constructors(text);
    check_larger_casts(text);
    check_groupshared_values(text);
    check_letter_swizzles(text);
    check_string_values(text, *entry);
    check_packed_members(text);
    check_missing_values(text, *entry);
    check_repeated_components(text);
    check_register_classes(text, *entry);
    check_array_sizes(text, *entry);
    check_operand_kinds(text);
    check_case_labels(text);
    check_repeated_globals(text);
  }
  for (const Pass& pass : passes()) pass.run(text);
  if (entry) refuse_absent_intrinsics(text);
  return {text.print(), text.notes(), std::move(semantics)};
}

}  // namespace penumbra::preparation
