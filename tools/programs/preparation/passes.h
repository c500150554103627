// The passes of prepare.h, in the order in which they run. Each says at its definition what it recognises,
// what it replaces that by and why the meaning is preserved. Internal to this folder.
#pragma once

#include "preparation/token_text.h"

namespace penumbra::preparation {

void pack_matrices(TokenText& text);
void make_constants_uniforms(TokenText& text);
void drop_uniform_of_parameters(TokenText& text);
void drop_texture_precision(TokenText& text);
void name_precision_matrices(TokenText& text);
void put_static_first(TokenText& text);
void plain_registers(TokenText& text);
void move_out_of_cbuffers(TokenText& text);
void return_from_empty_functions(TokenText& text);
void separate_dx9_samplers(TokenText& text);
void resolve_buffer_aliases(TokenText& text);
void separate_texture_reads(TokenText& text);
void merge_precision_overloads(TokenText& text);
void narrow_arguments(TokenText& text);
void drop_stray_semicolons(TokenText& text);
void drop_statement_attributes(TokenText& text);
void widen_matrix_casts(TokenText& text);
void write_out_matrix_swizzles(TokenText& text);
void define_intrinsics(TokenText& text);
void hide_constant_operands(TokenText& text);
void copy_written_uniforms(TokenText& text);

}  // namespace penumbra::preparation
