#include "resolve/program_on_device.h"

#include <algorithm>
#include <stdexcept>

#include "input/input_error.h"
#include "resolve/casters_on_device.h"

namespace penumbra::resolve {
namespace {

// Throws InputError with the names that are provided when this one is not. `where` is the shader, or the line
// that names the resource; `remedy` says how the user can provide it.
template <typename Map>
const auto& provided(const Map& map, const shaders::Resource& resource, const std::string& where,
                     const char* kind, const std::string& remedy = "") {
  const auto found = map.find(resource.name);
  if (found != map.end()) return *found->second;
  std::string known;
  for (const auto& entry : map) known += " " + entry.first;
  throw InputError(
      where,
      std::string("reads the ") + kind + " '" + resource.name + "', which the harness does not provide",
      (remedy.empty() ? "" : remedy + "; ") + "provided are:" + known);
}

constexpr const char* kSamplerNames =
    "a name with 'point' or 'linear' and with 'clamp' or 'repeat' (sampler_LinearClamp) is a sampler of that "
    "kind, and 'sampler' followed by the name of a texture of yours is linear and repeating";

// `declared_at` is the place of the pass in its manifest. If it is empty, the program is an adapter's.
std::string remedy_of(const shaders::Resource& missing, const std::string& declared_at) {
  if (!declared_at.empty()) {
    if (missing.kind == shaders::ResourceKind::storage_buffer)
      return "a manifest gives the pass at " + declared_at + " textures alone";
    const bool is_read = missing.kind == shaders::ResourceKind::sampled_image;
    return "give it to the pass at " + declared_at +
           (is_read ? R"( in "reads", or name it in "absent" if the program can do without)"
                    : R"( in "writes")");
  }
  if (missing.kind != shaders::ResourceKind::sampled_image) return "";
  const std::string& name = missing.name;
  return "give it one behind the adapter's file: ';" + name + "=picture.png' or ';" + name + "=white'";
}

gpu::RasterShaders raster_shaders(const CompiledProgram& program, const std::vector<std::uint32_t>& fragment,
                                  const TargetFormats& targets) {
  gpu::RasterShaders shaders;
  shaders.vertex = program.vertex;
  shaders.fragment = fragment;
  shaders.vertex_entry = program.vertex_entry;
  shaders.fragment_entry = program.entry;
  shaders.colours = targets.colours;
  shaders.depth = targets.depth;
  shaders.samples = targets.samples;
  shaders.keep = targets.keep;
  shaders.keep_depth = targets.stencil;
  if (program.render_commands.empty() && !targets.casters) return shaders;
  const RasterState state =
      raster_state(program.render_commands, program.file, targets.colours.size(), targets.reversed_z,
                   targets.stencil ? StencilTarget::has : StencilTarget::none);
  shaders.blends = state.blends;
  shaders.stencil = state.stencil;
  if (targets.stencil && state.depth_write)
    throw InputError(program.file, "pass '" + program.name + "' writes the depth that its stencil belongs to",
                     "give it ZWrite Off");
  shaders.depth_test = state.depth_test;
  shaders.depth_write = state.depth_write;
  if (!targets.casters) return shaders;
  if (!state.both_faces)
    throw InputError(program.file,
                     "pass '" + program.name + "' draws one face of its triangles, here both are drawn",
                     "give it Cull Off");
  if (targets.depth_is_shadow_map && state.depth_write)
    throw InputError(program.file, "pass '" + program.name + "' writes depth into the shadow map",
                     "give it ZWrite Off");
  shaders.depth_clamp = state.depth_clamp;
  shaders.constant_depth_bias = state.constant_depth_bias;
  shaders.slope_depth_bias = state.slope_depth_bias;
  for (const auto& [location, semantic] : program.vertex_inputs)
    shaders.inputs.push_back({location, CastersOnDevice::components(semantic)});
  return shaders;
}

void require_known_inputs(const CompiledProgram& program) {
  for (const auto& [location, semantic] : program.vertex_inputs)
    if (CastersOnDevice::components(semantic) == 0)
      throw InputError(program.file,
                       "pass '" + program.name + "' reads the vertex input " +
                           (semantic.empty() ? "at location " + std::to_string(location) : semantic) +
                           ", which casters do not have here",
                       "they have " + CastersOnDevice::semantics());
}

// Modules from bytecode have only the bytes of a block; `uniforms` has its members.
std::vector<shaders::Resource> with_uniforms(std::vector<shaders::Resource> resources,
                                             const std::vector<shaders::Resource>& uniforms) {
  for (shaders::Resource& resource : resources)
    for (const shaders::Resource& block : uniforms) {
      if (resource.kind != shaders::ResourceKind::uniform_block || resource.name != block.name) continue;
      resource.size = block.size;
      resource.members = block.members;
    }
  return resources;
}

// A vertex stage and a fragment stage have their uniforms from one text, so of two blocks with one name the
// longer is filled.
std::vector<shaders::Resource> joined(std::vector<shaders::Resource> resources,
                                      const std::vector<shaders::Resource>& of_vertex,
                                      const CompiledProgram& program) {
  for (const shaders::Resource& added : of_vertex) {
    const auto same =
        std::find_if(resources.begin(), resources.end(),
                     [&](const shaders::Resource& resource) { return resource.name == added.name; });
    if (same == resources.end()) {
      resources.push_back(added);
      continue;
    }
    for (std::size_t i = 0; i < std::min(same->members.size(), added.members.size()); ++i)
      if (same->members[i].name != added.members[i].name ||
          same->members[i].offset != added.members[i].offset)
        throw InputError(
            program.file,
            "pass '" + program.name +
                "' declares other uniforms in its vertex stage than in its "
                "fragment stage: '" +
                added.members[i].name + "' and '" + same->members[i].name + "'",
            "declare them outside of what depends on SHADER_STAGE_VERTEX and SHADER_STAGE_FRAGMENT");
    std::vector<bool> read;
    const shaders::Resource& shorter = same->size < added.size ? *same : added;
    for (const shaders::UniformMember& member : shorter.members) read.push_back(member.read);
    if (same->size < added.size) *same = added;
    for (std::size_t i = 0; i < read.size(); ++i) same->members[i].read = same->members[i].read || read[i];
  }
  return resources;
}

void refuse_bindings_of_the_vertex_stage(const CompiledProgram& program) {
  const std::vector<shaders::Resource> bound = shaders::reflect(program.vertex).resources;
  if (bound.empty() && program.vertex_inputs.empty()) return;
  const std::string read = bound.empty() ? program.vertex_inputs.begin()->second : bound.front().name;
  throw InputError(program.name, "the vertex stage reads '" + read + "'",
                   "the vertex stage of a pass over its whole target needs only SV_VertexID");
}

void require_shape(const shaders::Resource& resource, const gpu::ImageShape& shape,
                   const std::string& place) {
  const bool deep = (resource.image.dimensions == 3) == (shape.depth > 1);
  const bool layered = resource.image.arrayed || shape.layers == 1;
  const bool sampled = resource.image.multisampled == (shape.samples > 1);
  if (deep && layered && sampled) return;
  throw InputError(place,
                   "'" + resource.name + "' is declared as another kind of texture than is bound to it",
                   "3D, array and multisampled textures have types of their own");
}

void require_texels(const shaders::Resource& resource, gpu::Format format, const std::string& place) {
  const shaders::ScalarKind bound =
      gpu::is_integer(format) ? shaders::ScalarKind::uint32 : shaders::ScalarKind::float32;
  if (resource.image.texel == bound) return;
  const auto word = [](shaders::ScalarKind kind) {
    return kind == shaders::ScalarKind::uint32  ? "uint"
           : kind == shaders::ScalarKind::int32 ? "int"
                                                : "float";
  };
  throw InputError(place,
                   "'" + resource.name + "' is declared with components of " + word(resource.image.texel) +
                       ", and the texture that is bound to it has the format " + gpu::name(format),
                   std::string("declare it with components of ") + word(bound) + ", or change the format");
}

// Returns the images as pointers, which provided() takes.
std::map<std::string, const BoundImage*> pointers(const std::map<std::string, BoundImage>& images) {
  std::map<std::string, const BoundImage*> result;
  for (const auto& [name, image] : images) result[name] = &image;
  return result;
}

}  // namespace

gpu::RasterTile whole_of(const gpu::Image& target) {
  gpu::RasterTile tile;
  tile.width = target.width();
  tile.height = target.height();
  tile.vertex_count = 3;
  return tile;
}

ProgramOnDevice::ProgramOnDevice(const gpu::Device& device, const CompiledProgram& program, Module module,
                                 const TargetFormats& targets)
    : name_(program.name), declared_at_(program.declared_at), named_at_(program.named_at) {
  const std::vector<std::uint32_t>& words = module == Module::counting ? program.counting : program.plain;
  shaders::Reflection reflection = shaders::reflect(words);
  resources_ = with_uniforms(std::move(reflection.resources), program.uniforms);
  workgroup_size_ = reflection.workgroup_size;
  if (program.vertex.empty()) {
    compute_.emplace(device, gpu::ComputeShader{.spirv = words, .entry = program.entry});
  } else {
    if (targets.casters) {
      require_known_inputs(program);
      resources_ =
          joined(std::move(resources_),
                 with_uniforms(shaders::reflect(program.vertex).resources, program.vertex_uniforms), program);
      for (const auto& [location, semantic] : program.vertex_inputs) vertex_inputs_.push_back(semantic);
    } else {
      refuse_bindings_of_the_vertex_stage(program);
    }
    raster_.emplace(device, raster_shaders(program, words, targets));
  }
}

const std::string& ProgramOnDevice::place_of(const shaders::Resource& resource) const {
  const auto found = named_at_.find(resource.name);
  return found == named_at_.end() ? name_ : found->second;
}

gpu::Bindings ProgramOnDevice::bind(const NamedResources& resources) const {
  gpu::Bindings bindings = compute_ ? compute_->more_bindings() : raster_->more_bindings();
  const std::map<std::string, const BoundImage*> images = pointers(resources.images);
  for (const shaders::Resource& resource : resources_) {
    const std::string& place = place_of(resource);
    switch (resource.kind) {
      case shaders::ResourceKind::uniform_block:
        break;  // set_uniforms() fills these
      case shaders::ResourceKind::storage_buffer:
        bindings.buffer(resource.name, provided(resources.buffers, resource, place, "buffer",
                                                remedy_of(resource, declared_at_)));
        break;
      case shaders::ResourceKind::sampled_image:
      case shaders::ResourceKind::storage_image: {
        const bool written = resource.kind == shaders::ResourceKind::storage_image;
        const BoundImage& image = provided(images, resource, place, written ? "writable texture" : "texture",
                                           remedy_of(resource, declared_at_));
        require_shape(resource, image.image->shape(), place);
        require_texels(resource, image.image->shape().format, place);
        bindings.image(resource.name, *image.image, image.range);
        break;
      }
      case shaders::ResourceKind::sampler:
        bindings.sampler(resource.name,
                         provided(resources.samplers, resource, place, "sampler", kSamplerNames));
        break;
    }
  }
  return bindings;
}

std::vector<std::string> ProgramOnDevice::set_uniforms(gpu::Bindings& bindings, const UniformValues& values,
                                                       const UniformNumbers& numbers) const {
  std::vector<std::string> unset;
  for (const shaders::Resource& resource : resources_) {
    if (resource.kind != shaders::ResourceKind::uniform_block) continue;
    std::vector<std::byte> bytes = values.pack(resource, unset);
    write_numbers(numbers, resource, bytes);
    bindings.uniform_bytes(resource.name, bytes);
  }
  std::erase_if(unset, [&numbers](const std::string& name) { return has_numbers(numbers, name); });
  return unset;
}

void ProgramOnDevice::dispatch(gpu::Sequence& sequence, const gpu::Bindings& bindings,
                               std::array<std::uint32_t, 3> groups) const {
  sequence.dispatch(compute_.value(), bindings, groups);
}

void ProgramOnDevice::draw(gpu::Sequence& sequence, const gpu::Bindings& bindings,
                           const gpu::RasterTargets& targets, const gpu::RasterTile& tile,
                           const gpu::VertexStreams& streams) const {
  sequence.draw(raster_.value(), bindings, targets, {tile}, streams);
}

}  // namespace penumbra::resolve
