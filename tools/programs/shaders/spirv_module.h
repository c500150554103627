// Passes over a SPIR-V module between the front end and its user: bindings, legalisation, validation.
#pragma once

#include "hlsl/diagnostic.h"
#include "shaders/vulkan_version.h"
#include "spirv/module.h"

namespace penumbra::shaders {

using SpirvModule = spirv::Module;

// Gives every resource a unique binding number, 0, 1, 2, ... over all sets: HLSL's t0 and s0 are different
// registers, but the same Vulkan binding.
void number_bindings(SpirvModule& module);

// Adds `by` to every descriptor set.
void move_sets(SpirvModule& module, std::uint32_t by);

// Legalises HLSL's resource parameters, inlines and optimises. Returns false, with the reasons, if it failed.
bool optimise(SpirvModule& module, VulkanVersion vulkan, std::vector<std::string>& problems,
              SpirvModule* legalised = nullptr);

// Produces the final module: optimise(), then number_bindings() without unused resources, then uniform blocks
// that have no valid Vulkan layout as words (word_blocks.h).
bool finish(SpirvModule& module, VulkanVersion vulkan, std::vector<std::string>& problems,
            SpirvModule* legalised = nullptr);

// Returns the problems that SPIRV-Tools finds for that version; empty if valid. Before legalisation,
// resources may still be passed by value, which is then not reported.
std::vector<std::string> validation_problems(const SpirvModule& module, VulkanVersion vulkan,
                                             bool before_legalisation);

struct SourcePlace {
  std::string file;
  int line = 0;  // 1-based; 0 if unknown
};

// Returns an error there, about a construct that HLSL does not allow.
hlsl::Diagnostic error_at(const SourcePlace& place, std::string message);

// Returns the location of the first problem of an invalid module with debug lines.
SourcePlace problem_place(const SpirvModule& module, VulkanVersion vulkan);

// Constant arrays that code indexes. glslang copies the whole array into a local variable before each access
// (before SPIR-V 1.4, which its HLSL front end does not produce), and lavapipe executes the copies: a filter
// that reads a table of 100 points in a loop spends nearly all of its time on them.
//
// Local variables that hold one constant wherever they are stored, and are otherwise only read, get it as
// their initialiser in place of the stores: drivers then keep the table in constant memory. Meaning is
// unchanged.
void initialise_tables(SpirvModule& module);

}  // namespace penumbra::shaders
