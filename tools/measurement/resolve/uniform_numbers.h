// A user's numbers for a shader's uniforms, of whatever type the shader declares: scalars, vectors, matrices,
// arrays and structs.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "shaders/reflect.h"

namespace penumbra::resolve {

// The numbers by the name of a uniform ("_Taps"), an element ("_Taps[3]") or a field ("_Settings.radius",
// "_Lights[1].colour"). They fill it in the order of its declaration, a matrix row by row as mul(M, v) reads
// it.
using UniformNumbers = std::map<std::string, std::vector<double>>;

// Throws InputError for a name that none of the blocks has (with the nearest one and those that are read),
// for too few or too many numbers, and for an int uniform whose number is no integer. The message names the
// uniform's place, or else `shader`.
void check_numbers(const UniformNumbers& numbers, const std::vector<shaders::Resource>& resources,
                   const std::string& shader, const std::map<std::string, std::string>& places = {});

// Writes those of the numbers that belong to this block.
void write_numbers(const UniformNumbers& numbers, const shaders::Resource& block,
                   std::vector<std::byte>& bytes);

// Returns whether any of the numbers belongs to this uniform or a part of it.
bool has_numbers(const UniformNumbers& numbers, const std::string& uniform);

}  // namespace penumbra::resolve
