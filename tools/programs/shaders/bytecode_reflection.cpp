#include "shaders/bytecode_reflection.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <stdexcept>

#include "fxc/bytecode.h"

namespace penumbra::shaders {

namespace {

// The values are those of D3D_SHADER_INPUT_TYPE.
enum Input : std::uint32_t {
  cbuffer = 0,
  texture = 2,
  sampler = 3,
  rw_typed = 4,
  structured = 5,
  rw_structured = 6,
  bytes = 7,
  rw_bytes = 8
};

constexpr std::uint32_t most_types = 1U << 18U;  // a constant buffer has 2^16 bytes, so 2^14 numbers
constexpr std::uint32_t largest_block = 1U << 16U;
constexpr std::size_t longest_name = 4096;

// The values are those of D3D_SHADER_VARIABLE_CLASS.
enum Class : std::uint32_t { matrix_rows = 2, matrix_columns = 3, structure = 5 };

struct Type {
  std::uint32_t kind = 0;  // Class
  std::uint32_t scalar = 0;
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
  std::uint32_t elements = 0;  // 0 if it is no array
  std::uint32_t members = 0;
  std::size_t first_member = 0;

  bool is_matrix() const { return kind == matrix_rows || kind == matrix_columns; }
};

// A chunk's bytes, which may come from anywhere: every read beyond them throws std::invalid_argument.
class ChunkReader {
 public:
  ChunkReader(std::string_view bytecode, const char* name) {
    const std::optional<std::string_view> found = fxc::chunk(bytecode, name);
    if (!found) throw std::invalid_argument("the bytecode has no chunk " + std::string(name));
    bytes_ = *found;
  }

  std::uint32_t byte(std::size_t offset) const {
    if (offset >= bytes_.size()) throw std::invalid_argument("bytecode that ends too early");
    return static_cast<unsigned char>(bytes_[offset]);
  }
  std::uint32_t half(std::size_t offset) const { return byte(offset) | byte(offset + 1) << 8U; }
  std::uint32_t word(std::size_t offset) const { return half(offset) | half(offset + 2) << 16U; }

  std::string text(std::size_t offset) const {
    std::string text;
    for (; byte(offset) != 0; ++offset) {
      if (text.size() == longest_name) throw std::invalid_argument("bytecode with a name that is too long");
      text += static_cast<char>(byte(offset));
    }
    return text;
  }

 private:
  std::string_view bytes_;
};

// The chunk RDEF: Microsoft publishes its layout as the structures of d3d11shader.h.
class DefinitionReader {
 public:
  explicit DefinitionReader(std::string_view bytecode)
      : part_(bytecode, "RDEF"), longer_(part_.byte(17) >= 5) {}

  std::vector<BytecodeResource> resources() const {
    const std::size_t step = 32;
    std::vector<BytecodeResource> found;
    for (std::uint32_t i = 0; i < part_.word(8); ++i) found.push_back(resource(part_.word(12) + step * i));
    return found;
  }

 private:
  BytecodeResource resource(std::size_t at) const {
    constexpr std::uint32_t kBuffer = 1;  // D3D_SRV_DIMENSION_BUFFER
    BytecodeResource found;
    found.resource.name = part_.text(part_.word(at));
    found.index = part_.word(at + 20);
    if (part_.word(at + 24) != 1)
      throw std::invalid_argument("an array of resources, '" + found.resource.name + "'");
    const std::uint32_t input = part_.word(at + 4);
    switch (input) {
      case cbuffer:
        read_block(found.resource);
        return found;
      case sampler:
        found.registers = RegisterKind::sampler;
        found.resource.kind = ResourceKind::sampler;
        return found;
      case texture:
      case rw_typed:
        found.buffer = part_.word(at + 12) == kBuffer;
        found.registers = input == texture ? RegisterKind::texture : RegisterKind::writable;
        found.resource.kind = input == texture ? ResourceKind::sampled_image : ResourceKind::storage_image;
        return found;
      case structured:
      case bytes:
      case rw_structured:
      case rw_bytes:
        found.buffer = true;
        found.resource.kind = ResourceKind::storage_buffer;
        found.registers =
            input == structured || input == bytes ? RegisterKind::texture : RegisterKind::writable;
        return found;
      default:
        throw std::invalid_argument("a resource of a kind that is not run, '" + found.resource.name + "'");
    }
  }

  void read_block(Resource& block) const {
    const std::size_t step = 24;
    for (std::uint32_t i = 0; i < part_.word(0); ++i) {
      const std::size_t at = part_.word(4) + step * i;
      if (part_.text(part_.word(at)) != block.name || part_.word(at + 20) != 0) continue;
      block.size = part_.word(at + 12);
      if (block.size > largest_block)
        throw std::invalid_argument("bytecode with too large a constant buffer");
      for (std::uint32_t k = 0; k < part_.word(at + 4); ++k)
        block.members.push_back(member(part_.word(at + 8) + std::size_t{longer_ ? 40U : 24U} * k));
      if (block.name == "$Globals") block.name = "$Global";
      return;
    }
    throw std::invalid_argument("a constant buffer without a layout, '" + block.name + "'");
  }

  UniformMember member(std::size_t at) const {
    constexpr std::uint32_t kUsed = 2;  // D3D_SVF_USED
    UniformMember member;
    member.name = part_.text(part_.word(at));
    member.offset = part_.word(at + 4);
    member.size = part_.word(at + 8);
    member.read = (part_.word(at + 12) & kUsed) != 0;
    const Type of = type(part_.word(at + 16));
    member.array_length = of.elements;
    if (of.elements != 0) member.array_stride = element_bytes(of);
    if (of.is_matrix()) member.matrix_stride = 16;
    // A column_major matrix is RowMajor where glslang declares it: reflect.h.
    member.row_major = of.kind == matrix_columns;
    add_leaves(of, member.name, member.offset, member.leaves, 0);
    return member;
  }

  // Types may contain each other: bytes that come from no compiler can ask for very many.
  Type type(std::size_t at) const {
    if (++types_read_ > most_types) throw std::invalid_argument("bytecode with too large a constant buffer");
    return {part_.half(at),     part_.half(at + 2),  part_.half(at + 4), part_.half(at + 6),
            part_.half(at + 8), part_.half(at + 10), part_.word(at + 12)};
  }

  // Each element of an array begins a register.
  std::uint32_t element_bytes(const Type& of) const { return (bytes_of(of) + 15U) / 16U * 16U; }

  // Returns the bytes of one element, without padding behind it.
  std::uint32_t bytes_of(const Type& of, int depth = 0) const {
    require_shallow(depth);
    if (of.kind == matrix_rows) return 16 * (of.rows - 1) + 4 * of.columns;
    if (of.kind == matrix_columns) return 16 * (of.columns - 1) + 4 * of.rows;
    if (of.kind != structure) return 4 * of.columns;
    std::uint32_t end = 0;
    for (std::uint32_t i = 0; i < of.members; ++i) {
      const std::size_t at = of.first_member + std::size_t{12} * i;
      const Type field = type(part_.word(at + 4));
      std::uint32_t bytes = bytes_of(field, depth + 1);
      if (field.elements > 1) bytes += (field.elements - 1) * ((bytes + 15U) / 16U * 16U);
      end = std::max(end, part_.word(at + 8) + bytes);
    }
    return end;
  }

  void add_leaves(const Type& of, const std::string& path, std::uint32_t offset,
                  std::vector<UniformLeaf>& leaves, int depth) const {
    require_shallow(depth);
    const std::uint32_t stride = of.elements == 0 ? 0 : element_bytes(of);
    for (std::uint32_t i = 0; i < std::max(1U, of.elements); ++i) {
      const std::string element = of.elements == 0 ? path : path + "[" + std::to_string(i) + "]";
      if (of.kind == structure)
        add_fields(of, element, offset + i * stride, leaves, depth);
      else
        leaves.push_back(leaf(of, element, offset + i * stride));
      if (++leaves_read_ > most_types)
        throw std::invalid_argument("bytecode with too large a constant buffer");
    }
  }

  void add_fields(const Type& of, const std::string& path, std::uint32_t offset,
                  std::vector<UniformLeaf>& leaves, int depth) const {
    for (std::uint32_t i = 0; i < of.members; ++i) {
      const std::size_t at = of.first_member + std::size_t{12} * i;
      add_leaves(type(part_.word(at + 4)), path + "." + part_.text(part_.word(at)),
                 offset + part_.word(at + 8), leaves, depth + 1);
    }
  }

  static void require_shallow(int depth) {
    if (depth > 32) throw std::invalid_argument("bytecode with a type that contains itself");
  }

  static UniformLeaf leaf(const Type& of, const std::string& path, std::uint32_t offset) {
    UniformLeaf leaf{path, offset, scalar_kind(of.scalar), of.columns};
    if (!of.is_matrix()) return leaf;
    leaf.rows = of.columns;  // glslang's matrices are HLSL's transposed
    leaf.columns = of.rows;
    leaf.matrix_stride = 16;
    leaf.row_major = of.kind == matrix_columns;
    return leaf;
  }

  static ScalarKind scalar_kind(std::uint32_t type) {  // D3D_SHADER_VARIABLE_TYPE
    switch (type) {
      case 2:
        return ScalarKind::int32;
      case 3:
        return ScalarKind::float32;
      case 1:  // bool, as glslang declares it in a block
      case 19:
        return ScalarKind::uint32;
      default:
        return ScalarKind::other;
    }
  }

  ChunkReader part_;
  bool longer_;  // shader model 5
  mutable std::uint32_t types_read_ = 0;
  mutable std::uint32_t leaves_read_ = 0;
};

SignatureType signature_type(std::uint32_t component) {  // D3D_REGISTER_COMPONENT_TYPE
  switch (component) {
    case 1:
      return SignatureType::unsigned_integer;
    case 2:
      return SignatureType::signed_integer;
    case 3:
      return SignatureType::floating;
    default:
      return SignatureType::other;
  }
}

// The chunks of a signature: one of a geometry program of shader model 5 has a stream before each element,
// and one with minimum precisions a precision after it, too.
struct SignatureChunk {
  const char* input;
  const char* output;
  std::size_t step;   // bytes
  std::size_t first;  // byte of the name in an element
};
constexpr SignatureChunk signature_chunks[] = {
    {"ISGN", "OSGN", 24, 0}, {"ISG1", "OSG1", 32, 4}, {"ISGN", "OSG5", 28, 4}};

void add_elements(std::string_view bytecode, bool output, Signature& signature) {
  const auto name_of = [output](const SignatureChunk& chunk) { return output ? chunk.output : chunk.input; };
  const auto* found = std::find_if(
      std::begin(signature_chunks), std::end(signature_chunks),
      [&](const SignatureChunk& chunk) { return fxc::chunk(bytecode, name_of(chunk)).has_value(); });
  if (found == std::end(signature_chunks)) found = std::begin(signature_chunks);
  const ChunkReader part(bytecode, name_of(*found));
  for (std::uint32_t i = 0; i < part.word(0); ++i) {
    const std::size_t at = part.word(4) + found->step * i + found->first;
    SignatureElement element;
    element.written = part.text(part.word(at));
    element.semantic = element.written;
    std::transform(element.semantic.begin(), element.semantic.end(), element.semantic.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    const bool system = part.word(at + 8) != 0;
    const bool numbered = !element.semantic.starts_with("SV_") || element.semantic == "SV_TARGET";
    if (numbered) element.semantic += std::to_string(part.word(at + 4));
    element.output = output;
    element.location = system ? -1 : static_cast<int>(part.word(at + 16));
    element.type = signature_type(part.word(at + 12));
    element.components = std::popcount(part.byte(at + 20));
    element.read = !output && part.byte(at + 21) != 0;
    signature.push_back(std::move(element));
  }
}

}  // namespace

std::vector<BytecodeResource> bytecode_resources(std::string_view bytecode) {
  return DefinitionReader(bytecode).resources();
}

Signature bytecode_signature(std::string_view bytecode) {
  Signature signature;
  add_elements(bytecode, false, signature);
  add_elements(bytecode, true, signature);
  return signature;
}

}  // namespace penumbra::shaders
