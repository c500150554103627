// Direct3D 9's texture functions, expressed with Texture2D and similar types. Internal to this folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace penumbra::preparation {

struct Dx9Function {
  std::string_view dimension;  // "1D", "2D", "3D" or "CUBE"
  std::string_view kind;       // "", "bias", "grad", "lod" or "proj"
};

// Returns the parts of a name: tex2Dlod is {"2D", "lod"}.
std::optional<Dx9Function> dx9_function(std::string_view name);

// Returns "2D" for sampler2D; empty for other types.
std::string_view dx9_dimension(std::string_view type);

std::string texture_type(std::string_view dimension);  // "Texture2D"

// Returns the definition of the function of this name, with a texture and a sampler in place of the Direct3D
// 9 sampler; `arguments` is the number of arguments of the original call. The text is empty if there is no
// such function.
std::string dx9_definition(std::string_view name, int arguments);

}  // namespace penumbra::preparation
