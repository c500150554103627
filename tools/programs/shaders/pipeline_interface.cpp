#include "shaders/pipeline_interface.h"

#include <algorithm>
#include <tuple>

#include "shaders/spirv_cross_session.h"

namespace penumbra::shaders {

namespace {

struct Reflected {
  spvc_variable_id id;
  spvc_type type;
  std::string name;
};

class Reflector {
 public:
  explicit Reflector(const SpirvCrossSession& session) : session_(session) {
    spvc_set active = nullptr;
    session.require(spvc_compiler_get_active_interface_variables(session.compiler(), &active));
    session.require(
        spvc_compiler_create_shader_resources_for_active_variables(session.compiler(), &resources_, active));
  }

  std::vector<Reflected> list(spvc_resource_type kind) const {
    const spvc_reflected_resource* found = nullptr;
    std::size_t count = 0;
    session_.require(spvc_resources_get_resource_list_for_type(resources_, kind, &found, &count));
    std::vector<Reflected> list;
    for (std::size_t i = 0; i < count; ++i)
      list.push_back({found[i].id, spvc_compiler_get_type_handle(session_.compiler(), found[i].type_id),
                      found[i].name == nullptr ? "" : found[i].name});
    return list;
  }

  std::uint32_t decoration(const Reflected& variable, SpvDecoration decoration) const {
    return spvc_compiler_get_decoration(session_.compiler(), variable.id, decoration);
  }

  std::uint32_t struct_bytes(const Reflected& variable) const {
    std::size_t size = 0;
    session_.require(spvc_compiler_get_declared_struct_size(session_.compiler(), variable.type, &size));
    return static_cast<std::uint32_t>(size);
  }

 private:
  const SpirvCrossSession& session_;
  spvc_resources resources_ = nullptr;
};

constexpr std::pair<spvc_resource_type, DescriptorKind> descriptor_kinds[] = {
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, DescriptorKind::uniform_buffer},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, DescriptorKind::storage_buffer},
    {SPVC_RESOURCE_TYPE_SEPARATE_IMAGE, DescriptorKind::sampled_image},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, DescriptorKind::storage_image},
    {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, DescriptorKind::combined_image_sampler},
    {SPVC_RESOURCE_TYPE_SEPARATE_SAMPLERS, DescriptorKind::sampler},
    {SPVC_RESOURCE_TYPE_SUBPASS_INPUT, DescriptorKind::input_attachment},
};

// No device supports so many: an array of that size is an error, or malicious.
constexpr std::uint64_t most_elements = 1 << 20;
constexpr std::uint64_t most_locations = 128;

// Returns the elements over all dimensions of an array; 1 for anything else and where a dimension has no
// literal size.
std::uint32_t element_count(const Reflected& variable, std::uint64_t most) {
  std::uint64_t count = 1;
  for (unsigned i = 0; i < spvc_type_get_num_array_dimensions(variable.type); ++i) {
    if (spvc_type_array_dimension_is_literal(variable.type, i) == SPVC_FALSE) continue;
    count *= std::max<std::uint64_t>(1, spvc_type_get_array_dimension(variable.type, i));
    if (count > most)
      throw std::invalid_argument("the array '" + variable.name + "' has more than " + std::to_string(most) +
                                  " elements");
  }
  return static_cast<std::uint32_t>(count);
}

// An HLSL Buffer<T> is an image whose dimension is "Buffer", and has a descriptor of its own kind.
DescriptorKind refine(DescriptorKind kind, spvc_type type) {
  const spvc_basetype base = spvc_type_get_basetype(type);
  const bool is_image = base == SPVC_BASETYPE_IMAGE || base == SPVC_BASETYPE_SAMPLED_IMAGE;
  if (!is_image || spvc_type_get_image_dimension(type) != SpvDimBuffer) return kind;
  return kind == DescriptorKind::storage_image ? DescriptorKind::storage_texel_buffer
                                               : DescriptorKind::uniform_texel_buffer;
}

std::vector<Descriptor> descriptors_of(const Reflector& reflector) {
  std::vector<Descriptor> descriptors;
  for (const auto& [type, kind] : descriptor_kinds)
    for (const Reflected& variable : reflector.list(type))
      descriptors.push_back({refine(kind, variable.type), variable.name,
                             reflector.decoration(variable, SpvDecorationDescriptorSet),
                             reflector.decoration(variable, SpvDecorationBinding),
                             element_count(variable, most_elements)});
  return descriptors;
}

ScalarType scalar_type(const Reflected& variable) {
  switch (spvc_type_get_basetype(variable.type)) {
    case SPVC_BASETYPE_FP32:
      return ScalarType::float32;
    case SPVC_BASETYPE_INT32:
      return ScalarType::int32;
    case SPVC_BASETYPE_UINT32:
      return ScalarType::uint32;
    default:
      throw std::invalid_argument("the stage variable '" + variable.name +
                                  "' is not made of 32-bit floats or integers");
  }
}

std::vector<StageLocation> locations_of(const Reflector& reflector, spvc_resource_type kind) {
  std::vector<StageLocation> locations;
  for (const Reflected& variable : reflector.list(kind)) {
    StageLocation at;
    at.location = reflector.decoration(variable, SpvDecorationLocation);
    at.component = reflector.decoration(variable, SpvDecorationComponent);
    at.components = spvc_type_get_vector_size(variable.type);
    at.type = scalar_type(variable);
    const std::uint32_t count =
        element_count(variable, most_locations) * std::max(1U, spvc_type_get_columns(variable.type));
    for (std::uint32_t i = 0; i < count; ++i, ++at.location) locations.push_back(at);
  }
  std::sort(locations.begin(), locations.end(), [](const StageLocation& a, const StageLocation& b) {
    return std::tie(a.location, a.component) < std::tie(b.location, b.component);
  });
  return locations;
}

void choose_entry_point(const SpirvCrossSession& session, const std::string& entry) {
  const spvc_entry_point* entry_points = nullptr;
  std::size_t count = 0;
  session.require(spvc_compiler_get_entry_points(session.compiler(), &entry_points, &count));
  std::string known;
  for (std::size_t i = 0; i < count; ++i) {
    if (entry == entry_points[i].name) {
      session.require(spvc_compiler_set_entry_point(session.compiler(), entry_points[i].name,
                                                    entry_points[i].execution_model));
      return;
    }
    known += (known.empty() ? "" : ", ") + std::string(entry_points[i].name);
  }
  throw std::invalid_argument("the module has no entry point '" + entry + "'; it has " + known);
}

}  // namespace

PipelineInterface pipeline_interface(const std::vector<std::uint32_t>& spirv, const std::string& entry) {
  const SpirvCrossModule module(spirv);
  const SpirvCrossSession session(module, SPVC_BACKEND_NONE);
  choose_entry_point(session, entry);
  const Reflector reflector(session);
  PipelineInterface interface;
  interface.descriptors = descriptors_of(reflector);
  for (const Reflected& block : reflector.list(SPVC_RESOURCE_TYPE_PUSH_CONSTANT))
    interface.push_constant_bytes = reflector.struct_bytes(block);
  interface.inputs = locations_of(reflector, SPVC_RESOURCE_TYPE_STAGE_INPUT);
  interface.outputs = locations_of(reflector, SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
  return interface;
}

}  // namespace penumbra::shaders
