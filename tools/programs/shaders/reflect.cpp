#include "shaders/reflect.h"

#include <algorithm>
#include <utility>

#include "shaders/spirv_cross_session.h"

namespace penumbra::shaders {

namespace {

constexpr std::pair<spvc_resource_type, ResourceKind> kinds[] = {
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, ResourceKind::uniform_block},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, ResourceKind::storage_buffer},
    {SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, ResourceKind::sampled_image},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, ResourceKind::storage_image},
    {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, ResourceKind::sampler},
};

ScalarKind scalar_kind(spvc_basetype type) {
  switch (type) {
    case SPVC_BASETYPE_FP32:
      return ScalarKind::float32;
    case SPVC_BASETYPE_INT32:
      return ScalarKind::int32;
    case SPVC_BASETYPE_UINT32:
      return ScalarKind::uint32;
    default:
      return ScalarKind::other;
  }
}

// The offset and the name of a struct's member.
struct MemberPlace {
  spvc_type_id structure;
  unsigned index;
  std::string path;
  std::uint32_t offset;
};

bool add_leaves(const SpirvCrossSession& session, const MemberPlace& place, std::vector<UniformLeaf>& leaves);

bool add_fields(const SpirvCrossSession& session, spvc_type_id structure, const std::string& path,
                std::uint32_t offset, std::vector<UniformLeaf>& leaves) {
  const spvc_type type = spvc_compiler_get_type_handle(session.compiler(), structure);
  for (unsigned i = 0; i < spvc_type_get_num_member_types(type); ++i) {
    unsigned within = 0;
    session.require(spvc_compiler_type_struct_member_offset(session.compiler(), type, i, &within));
    const std::string name = spvc_compiler_get_member_name(session.compiler(), structure, i);
    if (!add_leaves(session, {structure, i, path + "." + name, offset + within}, leaves)) return false;
  }
  return true;
}

UniformLeaf leaf_at(const SpirvCrossSession& session, const MemberPlace& place, spvc_type type) {
  const spvc_compiler compiler = session.compiler();
  UniformLeaf leaf{place.path, place.offset, scalar_kind(spvc_type_get_basetype(type)),
                   spvc_type_get_vector_size(type), spvc_type_get_columns(type)};
  if (leaf.columns > 1) {
    const spvc_type structure = spvc_compiler_get_type_handle(compiler, place.structure);
    session.require(spvc_compiler_type_struct_member_matrix_stride(compiler, structure, place.index,
                                                                   &leaf.matrix_stride));
    leaf.row_major = spvc_compiler_has_member_decoration(compiler, place.structure, place.index,
                                                         SpvDecorationRowMajor) != SPVC_FALSE;
  }
  return leaf;
}

// Returns false for arrays of arrays.
bool add_leaves(const SpirvCrossSession& session, const MemberPlace& place,
                std::vector<UniformLeaf>& leaves) {
  const spvc_compiler compiler = session.compiler();
  const spvc_type structure = spvc_compiler_get_type_handle(compiler, place.structure);
  const spvc_type type =
      spvc_compiler_get_type_handle(compiler, spvc_type_get_member_type(structure, place.index));
  const unsigned dimensions = spvc_type_get_num_array_dimensions(type);
  if (dimensions > 1) return false;
  unsigned stride = 0;
  const unsigned length = dimensions == 0 ? 1 : spvc_type_get_array_dimension(type, 0);
  if (dimensions == 1) {
    session.require(spvc_compiler_type_struct_member_array_stride(compiler, structure, place.index, &stride));
  }
  for (unsigned i = 0; i < length; ++i) {
    MemberPlace element = place;
    element.offset += i * stride;
    if (dimensions == 1) element.path += "[" + std::to_string(i) + "]";
    if (spvc_type_get_num_member_types(type) == 0) {
      leaves.push_back(leaf_at(session, element, type));
    } else if (!add_fields(session, spvc_type_get_base_type_id(type), element.path, element.offset, leaves)) {
      return false;
    }
  }
  return true;
}

UniformMember reflect_member(const SpirvCrossSession& session, spvc_type_id block_id, unsigned index) {
  const spvc_compiler compiler = session.compiler();
  const spvc_type block = spvc_compiler_get_type_handle(compiler, block_id);
  const spvc_type type = spvc_compiler_get_type_handle(compiler, spvc_type_get_member_type(block, index));
  UniformMember member;
  member.name = spvc_compiler_get_member_name(compiler, block_id, index);
  session.require(spvc_compiler_type_struct_member_offset(compiler, block, index, &member.offset));
  if (const unsigned dimensions = spvc_type_get_num_array_dimensions(type); dimensions != 0) {
    member.array_length = spvc_type_get_array_dimension(type, dimensions - 1);  // the outermost
    session.require(
        spvc_compiler_type_struct_member_array_stride(compiler, block, index, &member.array_stride));
  }
  if (spvc_type_get_columns(type) > 1) {
    session.require(
        spvc_compiler_type_struct_member_matrix_stride(compiler, block, index, &member.matrix_stride));
    member.row_major =
        spvc_compiler_has_member_decoration(compiler, block_id, index, SpvDecorationRowMajor) != SPVC_FALSE;
  }
  std::size_t size = 0;
  session.require(spvc_compiler_get_declared_struct_member_size(compiler, block, index, &size));
  member.size = static_cast<std::uint32_t>(size);
  // SPIRV-Cross counts whole strides; the last element of a scalar or vector array needs less.
  if (member.array_length != 0 && member.matrix_stride == 0 && spvc_type_get_num_member_types(type) == 0 &&
      spvc_type_get_num_array_dimensions(type) == 1) {
    const std::uint32_t element = spvc_type_get_bit_width(type) / 8 * spvc_type_get_vector_size(type);
    member.size = member.array_stride * (member.array_length - 1) + element;
  }
  if (!add_leaves(session, {block_id, index, member.name, member.offset}, member.leaves))
    member.leaves.clear();
  return member;
}

// A block holds every uniform a file declares; a shader that includes a pipeline's reads a few of hundreds.
void mark_read_members(const SpirvCrossSession& session, spvc_variable_id block, Resource& resource) {
  const spvc_buffer_range* ranges = nullptr;
  std::size_t count = 0;
  session.require(spvc_compiler_get_active_buffer_ranges(session.compiler(), block, &ranges, &count));
  for (std::size_t i = 0; i < count; ++i) resource.members.at(ranges[i].index).read = true;
}

ImageType image_type(const SpirvCrossSession& session, const spvc_reflected_resource& reflected) {
  const spvc_type type = spvc_compiler_get_type_handle(session.compiler(), reflected.type_id);
  const SpvDim dimension = spvc_type_get_image_dimension(type);
  ImageType image;
  image.dimensions = dimension == SpvDim3D ? 3 : dimension == SpvDim1D ? 1 : 2;
  image.cube = dimension == SpvDimCube;
  image.arrayed = spvc_type_get_image_arrayed(type) != SPVC_FALSE;
  image.multisampled = spvc_type_get_image_multisampled(type) != SPVC_FALSE;
  image.texel = scalar_kind(spvc_type_get_basetype(
      spvc_compiler_get_type_handle(session.compiler(), spvc_type_get_image_sampled_type(type))));
  return image;
}

// glslang decorates the members of a StructuredBuffer, not the variable.
bool is_read_only(const SpirvCrossSession& session, ResourceKind kind,
                  const spvc_reflected_resource& reflected) {
  const spvc_compiler compiler = session.compiler();
  if (spvc_compiler_has_decoration(compiler, reflected.id, SpvDecorationNonWritable) != SPVC_FALSE)
    return true;
  if (kind != ResourceKind::storage_buffer) return false;
  const SpvDecoration* decorations = nullptr;
  std::size_t count = 0;
  session.require(spvc_compiler_get_buffer_block_decorations(compiler, reflected.id, &decorations, &count));
  return std::find(decorations, decorations + count, SpvDecorationNonWritable) != decorations + count;
}

Resource reflect_resource(const SpirvCrossSession& session, ResourceKind kind,
                          const spvc_reflected_resource& reflected) {
  const spvc_compiler compiler = session.compiler();
  Resource resource;
  resource.kind = kind;
  // A block is identified by its type's name; buffers of one element type share it, so they are identified by
  // the variable's.
  const std::string variable = spvc_compiler_get_name(compiler, reflected.id);
  resource.name = kind == ResourceKind::uniform_block || variable.empty() ? reflected.name : variable;
  resource.set = spvc_compiler_get_decoration(compiler, reflected.id, SpvDecorationDescriptorSet);
  resource.binding = spvc_compiler_get_decoration(compiler, reflected.id, SpvDecorationBinding);
  if (kind == ResourceKind::sampled_image || kind == ResourceKind::storage_image)
    resource.image = image_type(session, reflected);
  if (kind == ResourceKind::storage_image || kind == ResourceKind::storage_buffer)
    resource.written = !is_read_only(session, kind, reflected);
  if (kind != ResourceKind::uniform_block) return resource;
  const spvc_type block = spvc_compiler_get_type_handle(compiler, reflected.base_type_id);
  std::size_t size = 0;
  session.require(spvc_compiler_get_declared_struct_size(compiler, block, &size));
  resource.size = static_cast<std::uint32_t>(size);
  for (unsigned i = 0; i < spvc_type_get_num_member_types(block); ++i)
    resource.members.push_back(reflect_member(session, reflected.base_type_id, i));
  mark_read_members(session, reflected.id, resource);
  return resource;
}

}  // namespace

Reflection reflect(const std::vector<std::uint32_t>& spirv) {
  const SpirvCrossModule module(spirv);
  const SpirvCrossSession session(module, SPVC_BACKEND_NONE);
  const spvc_compiler compiler = session.compiler();
  spvc_set active = nullptr;
  spvc_resources resources = nullptr;
  session.require(spvc_compiler_get_active_interface_variables(compiler, &active));
  session.require(spvc_compiler_create_shader_resources_for_active_variables(compiler, &resources, active));
  Reflection reflection;
  for (const auto& [type, kind] : kinds) {
    const spvc_reflected_resource* list = nullptr;
    std::size_t count = 0;
    session.require(spvc_resources_get_resource_list_for_type(resources, type, &list, &count));
    for (std::size_t i = 0; i < count; ++i)
      reflection.resources.push_back(reflect_resource(session, kind, list[i]));
  }
  if (spvc_compiler_get_execution_model(compiler) == SpvExecutionModelGLCompute)
    for (unsigned axis = 0; axis < 3; ++axis)
      reflection.workgroup_size[axis] = std::max(
          1U, spvc_compiler_get_execution_mode_argument_by_index(compiler, SpvExecutionModeLocalSize, axis));
  return reflection;
}

}  // namespace penumbra::shaders
