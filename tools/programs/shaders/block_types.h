// The types of a module's uniform and storage blocks, with the offsets of their members. Internal to this
// folder.
#pragma once

#include <optional>
#include <unordered_map>

#include "shaders/spirv_module.h"
#include "spirv/words.h"

namespace penumbra::shaders {

// The sizes are in bytes, as the module decorates them.
struct BlockMember {
  std::uint32_t type = 0;
  std::uint32_t offset = 0;
  std::uint32_t matrix_stride = 0;  // 0 if it is not a matrix
  bool row_major = false;
};

struct BlockType {
  spv::Op op = spv::OpNop;
  std::uint32_t element = 0;  // type of a component, a column or an element
  std::uint32_t count = 0;    // components, columns, elements, or bits of a number; 0 for a runtime array
  std::uint32_t array_stride = 0;  // bytes
  std::vector<BlockMember> members;
};

// GL's two layout rules (OpenGL 4.5 specification, 7.6.2.2).
enum class BlockRule { std140, std430 };

class BlockTypes {
 public:
  explicit BlockTypes(const SpirvModule& module);

  // Returns null for a type that no block contains.
  const BlockType* find(std::uint32_t id) const;
  // Returns the value of a 32-bit integer constant.
  std::optional<std::uint32_t> constant(std::uint32_t id) const;
  // Returns whether every member has exactly the offset that the rule gives it.
  bool fits(std::uint32_t structure, BlockRule rule) const;
  // Returns whether a member begins in the padding after the last element of the array or struct before it,
  // as in HLSL's cbuffers, or of the matrix. Vulkan allows that only for matrices by rows (specification,
  // "Offset and Stride Assignment"), and OpenGL for none.
  bool fills_tails(std::uint32_t structure, bool of_rows) const;
  // Returns the size of a uniform block in registers of four words.
  std::uint32_t registers(std::uint32_t structure) const;

 private:
  struct Extent {
    std::uint32_t alignment = 1;
    std::uint32_t size = 0;
    bool fits = true;
  };

  void read(spirv::Words instruction);
  void decorate_member(spirv::Words instruction);
  Extent extent(const BlockMember& member, BlockRule rule) const;
  Extent vectors(const BlockMember& member, std::uint32_t components, std::uint32_t count,
                 BlockRule rule) const;
  Extent structure(std::uint32_t id, BlockRule rule) const;

  std::unordered_map<std::uint32_t, BlockType> types_;
  std::unordered_map<std::uint32_t, std::uint32_t> constants_;
  std::unordered_map<std::uint32_t, std::uint32_t> array_strides_;
  // The members of structs that are not defined yet.
  std::unordered_map<std::uint32_t, std::vector<BlockMember>> places_;
};

}  // namespace penumbra::shaders
