#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "hlsl/sampler_name.h"
#include "lint/program_rules.h"
#include "lint/stage_rules.h"
#include "spirv/code.h"

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

// `block_type` is the block's struct type.
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

// The limits are those of d3d11.h.
constexpr std::size_t most_samplers = 16;          // D3D11_COMMONSHADER_SAMPLER_SLOT_COUNT
constexpr std::size_t most_textures = 128;         // D3D11_COMMONSHADER_INPUT_RESOURCE_SLOT_COUNT
constexpr std::size_t most_constant_buffers = 14;  // D3D11_COMMONSHADER_CONSTANT_BUFFER_API_SLOT_COUNT
constexpr std::size_t most_writable = 8;           // D3D11_PS_CS_UAV_REGISTER_COUNT
constexpr std::size_t most_buffer_bytes = 65'536;  // D3D11_REQ_CONSTANT_BUFFER_ELEMENT_COUNT float4
constexpr std::size_t most_interpolators = 32;     // D3D11_PS_INPUT_REGISTER_COUNT
constexpr std::size_t most_shared_bytes = 32'768;  // D3D11_CS_THREAD_LOCAL_TEMP_REGISTER_POOL of cs_5_0
// VkPhysicalDeviceLimits::maxComputeSharedMemorySize and GL_MAX_COMPUTE_SHARED_MEMORY_SIZE of OpenGL ES 3.1
constexpr std::size_t promised_shared_bytes = 16'384;

enum class Kind { sampler, texture, constant_buffer, writable, shared, other };

struct Used {
  Kind kind = Kind::other;
  spirv::Id variable = 0;
  spirv::Id type = 0;  // type without arrays
  std::size_t slots = 1;
};

// Strips arrays, because an array takes a slot for every element.
Used described(const spirv::Code& code, const spirv::Instruction& variable) {
  Used used{Kind::other, variable.result, code.pointee(variable.type), 1};
  const spirv::Instruction* type = code.definition(used.type);
  while (type != nullptr && type->op == spv::OpTypeArray) {
    used.slots *=
        static_cast<std::size_t>(std::max<std::int64_t>(1, code.integer(type->operands[1]).value_or(1)));
    used.type = type->operands[0];
    type = code.definition(used.type);
  }
  if (type == nullptr) return used;
  const std::optional<spv::StorageClass> storage = code.storage_class(variable.type);
  if (storage == spv::StorageClassWorkgroup) {
    used.kind = Kind::shared;
  } else if (type->op == spv::OpTypeSampler) {
    used.kind = Kind::sampler;
  } else if (type->op == spv::OpTypeImage) {
    used.kind = type->operands[5] == 2 ? Kind::writable : Kind::texture;
  } else if (storage == spv::StorageClassStorageBuffer ||
             code.decoration(used.type, spv::DecorationBufferBlock)) {
    const bool read_only = code.decoration(variable.result, spv::DecorationNonWritable) ||
                           code.member_decoration(used.type, 0, spv::DecorationNonWritable);
    used.kind = read_only ? Kind::texture : Kind::writable;
  } else if (storage == spv::StorageClassUniform) {
    used.kind = Kind::constant_buffer;
  }
  return used;
}

std::vector<Used> used_resources(const spirv::Code& code) {
  std::set<spirv::Id> mentioned;
  for (const spirv::Function& function : code.functions())
    for (const spirv::Block& block : function.blocks)
      for (std::size_t i = block.begin; i < block.end; ++i)
        for (const spirv::Id id : code.ids(code.instructions()[i])) mentioned.insert(id);
  std::vector<Used> used;
  for (const spirv::Id id : mentioned) {
    const spirv::Instruction* definition = code.definition(id);
    if (definition == nullptr || definition->op != spv::OpVariable) continue;
    if (definition->operands[0] == spv::StorageClassFunction) continue;
    const Used resource = described(code, *definition);
    if (resource.kind != Kind::other) used.push_back(resource);
  }
  return used;
}

void check_sampler_names(const LintedCode& linted, const std::vector<Used>& used,
                         std::vector<hlsl::Diagnostic>& findings) {
  std::set<std::string> textures;
  for (const Used& resource : used)
    if (resource.kind == Kind::texture) textures.insert(linted.code.name(resource.variable));
  for (const Used& resource : used) {
    const std::string name = linted.code.name(resource.variable);
    if (resource.kind != Kind::sampler || name.empty() || is_inline_sampler(name)) continue;
    if (name.rfind("sampler", 0) == 0 && textures.contains(name.substr(7))) continue;
    const bool of_texture = name.rfind("sampler_", 0) == 0;
    findings.push_back(finding_at_declaration(
        linted, "sampler-name", name, {"SamplerState", "SamplerComparisonState", "SAMPLER"},
        "sampler '" + name + "' is not named after a texture that this shader samples" +
            (of_texture ? " ('" + name.substr(7) + "' is not)" : "") +
            ", nor after a filter and a wrap mode, such as sampler_linear_clamp"));
  }
}

// Returns whether the name is that of glslang's buffer for the counter of an AppendStructuredBuffer or
// similar: in Direct3D it is part of the buffer.
bool is_counter(const std::string& name) {
  return name.ends_with("@count");
}

// A limit on the number of resources of a kind, and how its message speaks of them.
struct CountLimit {
  const char* rule;
  Kind kind;
  std::size_t most;
  const char* what;
  const char* remedy;
  std::vector<std::string> declaring;  // words in their declarations
};

const std::vector<CountLimit>& count_limits() {
  static const std::vector<CountLimit> all{
      {"sampler-limit",
       Kind::sampler,
       most_samplers,
       "samplers",
       "sample several textures with one, such as sampler_linear_repeat",
       {"SamplerState", "SamplerComparisonState", "SAMPLER", "sampler", "TEX"}},
      {"register-limit",
       Kind::texture,
       most_textures,
       "textures and read-only buffers",
       "put textures of one size into a Texture2DArray",
       {"Texture", "TEXTURE", "Buffer"}},
      {"register-limit",
       Kind::constant_buffer,
       most_constant_buffers,
       "constant buffers",
       "put several into one",
       {"cbuffer", "CBUFFER_START", "ConstantBuffer"}},
      {"register-limit",
       Kind::writable,
       most_writable,
       "writable textures and buffers",
       "put several into one buffer of a struct, or write them in two dispatches",
       {"RW", "AppendStructuredBuffer", "ConsumeStructuredBuffer"}}};
  return all;
}

void check_count(const LintedCode& linted, const std::vector<Used>& used, const CountLimit& limit,
                 std::vector<hlsl::Diagnostic>& findings) {
  std::size_t slots = 0;
  std::string names;
  std::string first_above;
  for (const Used& resource : used) {
    if (resource.kind != limit.kind || is_counter(linted.code.name(resource.variable))) continue;
    slots += resource.slots;
    const std::string name = limit.kind == Kind::constant_buffer ? linted.code.name(resource.type)
                                                                 : linted.code.name(resource.variable);
    names += (names.empty() ? "" : ", ") + name;
    if (slots > limit.most && first_above.empty()) first_above = name;
  }
  if (slots <= limit.most) return;
  findings.push_back(finding_at_declaration(
      linted, limit.rule, first_above, limit.declaring,
      std::to_string(slots) + " " + limit.what + " are used; Direct3D 11 has " + std::to_string(limit.most) +
          ", and '" + first_above + "' is the first above: " + limit.remedy + " (" + names + ")"));
}

void check_sizes(const LintedCode& linted, const std::vector<Used>& used,
                 std::vector<hlsl::Diagnostic>& findings) {
  for (const Used& resource : used) {
    if (resource.kind != Kind::constant_buffer) continue;
    const ConstantBuffer buffer = constant_buffer(linted.code, resource.type);
    if (buffer.size <= most_buffer_bytes) continue;
    findings.push_back(finding_at_declaration(
        linted, "register-limit", buffer.name, {"cbuffer", "CBUFFER_START", "ConstantBuffer"},
        "constant buffer '" + buffer.name + "' has " + std::to_string(buffer.size) +
            " bytes; Direct3D 11 has 65536"));
  }
}

// The number of scalar components of a value between stages or in group shared memory, and the number of
// registers without packing.
struct Footprint {
  std::size_t components = 0;
  std::size_t registers = 0;
};
Footprint footprint(const spirv::Code& code, spirv::Id type) {
  const spirv::Instruction* of = code.definition(type);
  if (of == nullptr) return {};
  const auto times = [&](spirv::Id inner, std::size_t number) {
    const Footprint part = footprint(code, inner);
    return Footprint{part.components * number, part.registers * number};
  };
  switch (of->op) {
    case spv::OpTypeVector:
      return {of->operands[1], 1};
    case spv::OpTypeMatrix:
      return times(of->operands[0], of->operands[1]);
    case spv::OpTypeArray:
      return times(of->operands[0], static_cast<std::size_t>(code.integer(of->operands[1]).value_or(1)));
    case spv::OpTypeStruct: {
      Footprint sum;
      for (const spirv::Id member : of->operands) {
        const Footprint part = footprint(code, member);
        sum = {sum.components + part.components, sum.registers + part.registers};
      }
      return sum;
    }
    default:
      return {1, 1};
  }
}

std::size_t interpolators_of_target(int shader_target) {
  if (shader_target == 0 || shader_target >= 40) return most_interpolators;
  return shader_target >= 35 ? 15 : shader_target >= 30 ? 10 : 8;
}

void check_interpolators(const LintedCode& linted, hlsl::Stage stage, int shader_target,
                         std::vector<hlsl::Diagnostic>& findings) {
  const bool reads = stage == hlsl::Stage::fragment;
  if (!reads && stage != hlsl::Stage::vertex && stage != hlsl::Stage::domain) return;
  const spv::StorageClass storage = reads ? spv::StorageClassInput : spv::StorageClassOutput;
  Footprint sum;
  for (const spirv::Instruction& variable : linted.code.instructions()) {
    if (variable.op != spv::OpVariable || variable.operands[0] != static_cast<std::uint32_t>(storage))
      continue;
    if (!linted.code.decoration(variable.result, spv::DecorationLocation)) continue;
    const Footprint part = footprint(linted.code, linted.code.pointee(variable.type));
    sum.components += part.components;
    sum.registers += part.registers;
  }
  const std::size_t packed = (sum.components + 3) / 4;
  if (packed > most_interpolators) {
    findings.push_back(finding_at(linted, "register-limit", {}, {},
                                  "at least " + std::to_string(packed) +
                                      " interpolators are used; Direct3D 11 has " +
                                      std::to_string(most_interpolators)));
    return;
  }
  const std::size_t most = interpolators_of_target(shader_target);
  if (sum.registers <= most) return;
  hlsl::Diagnostic finding =
      finding_at(linted, "register-limit", {}, {},
                 std::to_string(sum.registers) + " interpolators are used; devices of #pragma target " +
                     std::to_string(shader_target / 10) + "." + std::to_string(shader_target % 10) +
                     " may have only " + std::to_string(most));
  finding.severity = hlsl::Severity::note;
  findings.push_back(finding);
}

void check_shared_memory(const LintedCode& linted, const std::vector<Used>& used,
                         std::vector<hlsl::Diagnostic>& findings) {
  std::size_t bytes = 0;
  std::vector<std::pair<std::size_t, std::string>> variables;
  for (const Used& resource : used) {
    if (resource.kind != Kind::shared) continue;
    const spirv::Instruction* variable = linted.code.definition(resource.variable);
    variables.emplace_back(4 * footprint(linted.code, linted.code.pointee(variable->type)).components,
                           linted.code.name(resource.variable));
    bytes += variables.back().first;
  }
  if (bytes <= promised_shared_bytes) return;
  std::sort(variables.rbegin(), variables.rend());
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, variables.size()); ++i)
    names += (i == 0 ? "'" : ", '") + variables[i].second + "' " + std::to_string(variables[i].first);
  const bool above = bytes > most_shared_bytes;
  hlsl::Diagnostic finding = finding_at_declaration(
      linted, "register-limit", variables[0].second, {"groupshared"},
      std::to_string(bytes) + " bytes of group shared memory are used (" + names + "); " +
          (above ? "Direct3D 11 and Metal have 32768: keep values in 16 bits, or let the group be smaller"
                 : "some devices with Vulkan or OpenGL ES have only 16384"));
  if (!above) finding.severity = hlsl::Severity::note;
  findings.push_back(std::move(finding));
}

bool has_one_component(std::uint32_t format) {
  return format == spv::ImageFormatR32f || format == spv::ImageFormatR32i || format == spv::ImageFormatR32ui;
}

void check_typed_loads(const LintedCode& linted, std::vector<hlsl::Diagnostic>& findings) {
  for (const spirv::Instruction& read : linted.code.instructions()) {
    if (read.op != spv::OpImageRead) continue;
    const spirv::Instruction* image = linted.code.definition(read.operands[0]);
    const spirv::Instruction* type = image == nullptr ? nullptr : linted.code.definition(image->type);
    if (type == nullptr || type->operands[1] == spv::DimSubpassData ||
        type->operands[6] == spv::ImageFormatUnknown || has_one_component(type->operands[6]))
      continue;
    const std::string name = linted.code.name(image->op == spv::OpLoad ? image->operands[0] : 0);
    findings.push_back(
        finding_at(linted, "typed-load", read.place, {name},
                   "'" + name +
                       "' is read, and Direct3D 11 promises that only of writable textures and buffers of "
                       "one float, int or "
                       "uint: read a copy that is a Texture2D, use a buffer of a struct, or ask "
                       "SystemInfo.SupportsTypedUAVShaderLoadStoreOnGraphicsFormat first"));
  }
}

}  // namespace

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

std::vector<hlsl::Diagnostic> resource_findings(const LintedCode& linted, hlsl::Stage stage,
                                                int shader_target) {
  std::vector<hlsl::Diagnostic> findings;
  const std::vector<Used> used = used_resources(linted.code);
  check_sampler_names(linted, used, findings);
  for (const CountLimit& limit : count_limits()) check_count(linted, used, limit, findings);
  check_sizes(linted, used, findings);
  check_interpolators(linted, stage, shader_target, findings);
  check_shared_memory(linted, used, findings);
  check_typed_loads(linted, findings);
  return findings;
}

bool is_inline_sampler(std::string_view name) {
  const hlsl::SamplerName words = hlsl::read_sampler_name(name);
  return (words.point || words.linear) && (words.clamp || words.repeat || words.mirror);
}

}  // namespace penumbra::lint
