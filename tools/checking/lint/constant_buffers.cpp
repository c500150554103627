#include "lint/constant_buffers.h"

#include <algorithm>
#include <utility>

namespace penumbra::lint {

namespace {

constexpr int deepest_type = 64;

// Returns the bytes from a member's start to its end, without padding after the last element. `matrix_stride`
// is the member's own decoration.
std::uint64_t size_of(const spirv::Code& code, spirv::Id type, std::uint32_t matrix_stride, bool row_major,
                      int depth) {
  const spirv::Instruction* of = code.definition(type);
  if (of == nullptr || depth > deepest_type) return 0;
  const auto inner = [&](spirv::Id part) { return size_of(code, part, matrix_stride, row_major, depth + 1); };
  switch (of->op) {
    case spv::OpTypeInt:
    case spv::OpTypeFloat:
      return of->operands[0] / 8;
    case spv::OpTypeBool:
      return 4;
    case spv::OpTypeVector:
      return of->operands[1] * inner(of->operands[0]);
    case spv::OpTypeMatrix: {
      const spirv::Instruction* column = code.definition(of->operands[0]);
      const std::uint64_t scalar = inner(column->operands[0]);
      const std::uint32_t rows = column->operands[1];
      const std::uint32_t columns = of->operands[1];
      const std::uint32_t lines = row_major ? rows : columns;
      return std::uint64_t{lines - 1} * matrix_stride + scalar * (row_major ? columns : rows);
    }
    case spv::OpTypeArray: {
      const auto length =
          static_cast<std::uint64_t>(std::max<std::int64_t>(1, code.integer(of->operands[1]).value_or(1)));
      const std::uint32_t stride = code.decoration(type, spv::DecorationArrayStride).value_or(0);
      return (length - 1) * stride + inner(of->operands[0]);
    }
    case spv::OpTypeStruct: {
      std::uint64_t end = 0;
      for (std::uint32_t i = 0; i < of->operands.size(); ++i) {
        const std::uint32_t stride = code.member_decoration(type, i, spv::DecorationMatrixStride).value_or(0);
        const bool rows = code.member_decoration(type, i, spv::DecorationRowMajor).has_value();
        end = std::max(end, code.member_decoration(type, i, spv::DecorationOffset).value_or(0) +
                                size_of(code, of->operands[i], stride, rows, depth + 1));
      }
      return end;
    }
    default:
      return 0;
  }
}

}  // namespace

ConstantBuffer constant_buffer(const spirv::Code& code, spirv::Id block_type) {
  ConstantBuffer buffer;
  buffer.name = code.name(block_type);
  const spirv::Instruction* block = code.definition(block_type);
  if (block == nullptr || block->op != spv::OpTypeStruct) return buffer;
  for (std::uint32_t i = 0; i < block->operands.size(); ++i) {
    const std::uint32_t stride =
        code.member_decoration(block_type, i, spv::DecorationMatrixStride).value_or(0);
    const bool rows = code.member_decoration(block_type, i, spv::DecorationRowMajor).has_value();
    const std::uint32_t offset = code.member_decoration(block_type, i, spv::DecorationOffset).value_or(0);
    const std::uint64_t size = size_of(code, block->operands[i], stride, rows, 0);
    buffer.members.push_back({code.member_name(block_type, i), offset, size});
    buffer.size = std::max(buffer.size, offset + size);
  }
  return buffer;
}

std::vector<ConstantBuffer> constant_buffers(const std::vector<std::uint32_t>& spirv) {
  const spirv::Code code(spirv);
  std::vector<ConstantBuffer> buffers;
  for (const spirv::Instruction& variable : code.instructions()) {
    if (variable.op != spv::OpVariable || variable.operands[0] != spv::StorageClassUniform) continue;
    const spirv::Id type = code.pointee(variable.type);
    if (code.op(type) != spv::OpTypeStruct || code.decoration(type, spv::DecorationBufferBlock)) continue;
    buffers.push_back(constant_buffer(code, type));
  }
  return buffers;
}

}  // namespace penumbra::lint
