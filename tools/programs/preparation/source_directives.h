// Pragmas and literals that are rewritten before the preprocessor reads a file, without moving a character.
//
// - `#pragma pack_matrix(...)` becomes an identifier that matrix_layout.cpp reads after the preprocessor.
//   Other pragmas are read by the code in variants/, and the preprocessor skips them.
// - `#pragma warning(disable : 3206)` becomes an identifier, too, which is for FXC alone (with_pragmas), if
// it fits.
// - The half literal `1.0h` becomes `1.0f`: half is float here. `1.#INF` becomes `1e9999`, which is infinite
//   too, and is accepted by the preprocessor.
// - Of an integer literal with a suffix and 33 to 64 bits, `0x1376312589U`, the low 32 bits stay,
// `0x0076312589U`:
//   FXC takes these, glslang refuses the number. Without a suffix FXC refuses it, too.
// - The character literals 'N' and '\n' become their numeric values
//   (learn.microsoft.com/windows/win32/direct3dhlsl/dx-graphics-hlsl-appendix-grammar), which glslang does
//   not know.
//
// Guarantees: the length, every newline and every column are preserved. Comments and string literals are not
// changed.
#pragma once

#include <string>
#include <string_view>

namespace penumbra::preparation {

// These identifiers replace #pragma pack_matrix, followed by a ';'.
inline constexpr std::string_view kPackedByRows = "penumbra_by_rows";
inline constexpr std::string_view kPackedByColumns = "penumbra_by_columns";
inline constexpr std::string_view kPackedOtherwise = "penumbra_packed";

// This begins the identifier that replaces #pragma warning: the specifier's first two letters and the numbers
// follow, as in "penumbra_w_di_3206_3556".
inline constexpr std::string_view kWarningPragma = "penumbra_w_";

std::string prepare_source(std::string text);

// Returns the expanded text with these identifiers as pragmas again, for a compiler that knows them. No line
// is added or moved.
std::string with_pragmas(const std::string& expanded);

}  // namespace penumbra::preparation
