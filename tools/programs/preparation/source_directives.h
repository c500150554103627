// What has to be said differently before the preprocessor reads a file, without moving a character.
//
// - `#include_with_pragmas "x"` (Unity's, docs.unity3d.com/Manual/shader-include-directives.html) becomes an
//   `#include`: its pragmas are read by the variants room.
// - `#pragma` lines are blanked, for the same reason; `#pragma once` is reported, for the one who opens
// files.
// - `#pragma pack_matrix(...)` becomes a word that matrix_packing.h reads after the preprocessor.
// - `#warning` is blanked: it is no error in Unity, and glslang knows no such directive.
// - The half literal `1.0h` becomes `1.0f`: the precision of half is float here. `1.#INF` becomes `1e9999`,
// which
//   is infinite too, and survives the preprocessor.
// - The character literals 'N' and '\n' become the numbers that they stand for
//   (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-grammar): glslang's
//   preprocessor loses their quotes.
//
// Guarantees: the length, every newline and every column stay. Comments and texts in quotes are left alone.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::preparation {

// What stands for #pragma pack_matrix, with a ';'.
inline constexpr std::string_view kPackedByRows = "penumbra_by_rows";
inline constexpr std::string_view kPackedByColumns = "penumbra_by_columns";
inline constexpr std::string_view kPackedOtherwise = "penumbra_packed";

struct PreparedSource {
  std::string text;
  bool once = false;  // the file says `#pragma once` outside comments
};

PreparedSource prepare_source(std::string text);

}  // namespace penumbra::preparation
