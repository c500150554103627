// A user's numbers for a shader's uniforms, of whatever type the shader declares: scalars, vectors, matrices,
// arrays and structs.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "shaders/reflect.h"

namespace penumbra::resolve {

// By name: a uniform ("_Taps"), an element ("_Taps[3]") or a field ("_Settings.radius", "_Lights[1].colour").
// The numbers fill it in the order of its declaration, a matrix row by row as mul(M, v) reads it.
using UniformNumbers = std::map<std::string, std::vector<double>>;

// Throws InputError for a name that none of the blocks has (with the nearest one and those that are read),
// for too few or too many numbers, and for an int uniform whose number is none. The message names the
// uniform's place, or else `shader`.
void check_numbers(const UniformNumbers& numbers, const std::vector<shaders::Resource>& resources,
                   const std::string& shader, const std::map<std::string, std::string>& places = {});

// Writes what of the numbers belongs into this block.
void write_numbers(const UniformNumbers& numbers, const shaders::Resource& block,
                   std::vector<std::byte>& bytes);

// Whether any of the numbers is of this uniform or a part of it.
bool has_numbers(const UniformNumbers& numbers, const std::string& uniform);

}  // namespace penumbra::resolve
