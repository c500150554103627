// Checks for what a user's function may not do though it compiles: drivers crash on it, or its results mean
// nothing. Internal to this folder.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace penumbra::resolve {

// `unoptimised` is the function's module before optimisation, with debug lines; `places` is
// CompiledShadowShader::named_at. Throws InputError, naming the line or else the shader, for
// - a comparison through a sampler that does not compare, and other reads through one that does;
// - `discard` and `clip`;
// - textures other than plain 2D ones;
// - a ShadowVisibility that returns more than one number.
void check_adapter(std::vector<std::uint32_t> unoptimised, const std::string& shader,
                   const std::map<std::string, std::string>& places);

}  // namespace penumbra::resolve
