#include "resolve/graph_runner.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

#include "input/input_error.h"
#include "resolve/graph_resources.h"
#include "resolve/pass_geometry.h"
#include "resolve/texel_counter.h"
#include "shaders/counted_module.h"
#include "techniques/technique_call.h"
#include "techniques/texel_formats.h"

namespace penumbra::resolve {
namespace {

using techniques::GraphPass;
using techniques::GraphTexture;
using techniques::PassGraph;
using techniques::PassKind;

template <typename Count>
double sum(const std::vector<Count>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0);
}

// Returns for each pixel of the screen, rows from the top, the value of `of` for the texel of a smaller image
// that covers it.
template <typename Texel, typename Of>
auto at_each_pixel(const std::vector<Texel>& texels, int width, int divisor, const CameraImage& camera,
                   Of of) {
  std::vector<decltype(of(texels.front()))> pixels;
  pixels.reserve(camera.depth.size());
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      pixels.push_back(of(texels[static_cast<std::size_t>(y / divisor) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x / divisor)]));
    }
  }
  return rows_from_top(pixels, camera.width, camera.rows);
}

void add(std::vector<float>& sums, const std::vector<float>& terms) {
  if (sums.empty()) sums.resize(terms.size());
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += terms[i];
}

TargetFormats target_formats(const ShadowGraph& source, const GraphPass& pass, gpu::Format shadow_map) {
  const PassGraph& graph = source.graph;
  TargetFormats formats;
  formats.reversed_z = source.reversed_z;
  if (pass.kind == PassKind::filter)
    formats.colours = {gpu::Format::r32f};  // the result of a function in a fragment shader
  if (!techniques::is_drawn(pass.kind)) return formats;
  for (const auto& [shader_name, name] : pass.writes) {
    formats.colours.push_back(measured_format(*graph.texture(name)));
    formats.samples = graph.texture(name)->samples;
  }
  formats.stencil = !pass.stencil.empty();
  if (const GraphTexture* depth = graph.texture(formats.stencil ? pass.stencil : pass.depth)) {
    formats.depth = measured_format(*depth);
    formats.samples = depth->samples;
  }
  if (pass.kind == PassKind::casters) {
    formats.casters = formats.keep = true;  // cleared before the first draw
    formats.depth_is_shadow_map = pass.depth == techniques::shadow_map_name;
    if (formats.depth_is_shadow_map) formats.depth = shadow_map;
    return formats;
  }
  // The other cascades' tiles are kept.
  formats.keep = pass.frequency == techniques::Frequency::cascade &&
                 graph.texture(pass.writes.front().second)->extent == techniques::ExtentOf::map;
  return formats;
}

// Checks a user's numbers for uniforms that the function reads.
void check_numbers_of(const ShadowShader& shader, const CompiledProgram& program,
                      const ProgramOnDevice& on_device) {
  const auto function = program.named_at.find("ShadowVisibility");
  check_numbers(shader.numbers, on_device.resources(),
                function == program.named_at.end() ? shader.name : function->second, program.named_at);
}

}  // namespace

// The graph's textures and the steps of one module for one frame.
class GraphRunner::Run {
 public:
  Run(GraphRunner& runner, const FrameOnDevice& frame, const CameraImage* camera,
      const CameraImage* second_eye, ProgramOnDevice::Module module)
      : runner_(runner),
        frame_(frame),
        camera_(camera),
        second_eye_(second_eye),
        extents_{camera == nullptr ? frame.width() : camera->width,
                 camera == nullptr ? frame.height() : camera->height, frame.map_layout()},
        resources_(*runner.device_, runner.graph(), extents_),
        geometry_(runner.graph(), resources_, extents_),
        sequence_(*runner.device_),
        counting_(module == ProgramOnDevice::Module::counting) {
    require_whole_tiles(runner.graph(), runner.graph_.source.name, extents_.map.tile,
                        extents_.map.width / extents_.map.tile);
    if (runner.graph().over_screen() && camera == nullptr)
      throw std::invalid_argument("a graph over the screen needs a camera");
    if (camera != nullptr) {
      depth_.emplace(*runner.device_, gpu::ImageShape{.format = gpu::Format::r32f,
                                                      .width = camera->width,
                                                      .height = camera->height,
                                                      .layers = second_eye == nullptr ? 1 : 2});
      depth_->upload(camera->depth);
      if (second_eye != nullptr) depth_->upload(second_eye->depth, {.layer = 1});
    }
    for (std::size_t i = 0; i < runner.graph().passes.size(); ++i) {
      add_pass(i);
      pass_of_step_.resize(sequence_.size(), i);
    }
  }

  // Returns the time of each pass in nanoseconds, from the times that Sequence::run() gives for its steps.
  // `before` is the frame whose history this one has; null if it has none.
  std::vector<double> run(int seed, const Run* before = nullptr) {
    UniformValues values = frame_.uniforms(seed);
    values.merge(runner_.own_.uniforms());
    values.merge(runner_.graph_.source.parameters);
    if (camera_ != nullptr) set_screen(values, *camera_, second_eye_);
    if (runner_.graph().has_history()) take_history(values, before);
    for (Step& step : steps_) {
      UniformValues all = values;
      if (step.part != nullptr) all.merge(frame_.casters()->uniforms());
      if (step.part != nullptr) all.merge(step.part->uniforms);
      all.merge(step.uniforms);
      const bool is_filter = runner_.graph().passes[step.pass].kind == PassKind::filter;
      for (const std::string& name :
           program(step.pass, step.part)
               .set_uniforms(step.bindings, all, is_filter ? numbers() : UniformNumbers{}))
        if (!name.starts_with(shaders::texel_bytes_name)) unset_.insert(name);  // nothing accesses these
    }
    return times_of_passes(sequence_.run());
  }

  // The names that a run has found: their uniforms read as zero because nobody provides them.
  const std::set<std::string>& unset_uniforms() const { return unset_; }

  std::vector<float> visibility() const {
    const std::string& name = runner_.graph().visibility;
    if (name.empty()) return frame_.visibility().download<float>();
    std::vector<float> seen = rows_from_top(texels(name), camera_->width, camera_->rows);
    if (second_eye_ == nullptr) return seen;
    const std::vector<float> second = rows_from_top(texels(name, 1), camera_->width, camera_->rows);
    seen.insert(seen.end(), second.begin(), second.end());
    return seen;
  }

  std::vector<std::uint8_t> masked_out() const {
    const std::string& name = runner_.graph().mask;
    if (name.empty()) return {};
    return at_each_pixel(texels(name), resources_.texture(name).width(),
                         runner_.graph().texture(name)->divisor, *camera_,
                         [](float texel) { return static_cast<std::uint8_t>(texel < 0.5f ? 1 : 0); });
  }

  // Adds the counts of a run of the counting modules.
  void add_counts(GraphResult& result) const {
    const double pixels = static_cast<double>(extents_.screen_width) * extents_.screen_height;
    const auto receivers = static_cast<std::size_t>(pixels);
    result.fetches.assign(receivers, 0);
    for (std::size_t i = 0; i < runner_.graph().passes.size(); ++i) {
      const GraphPass& pass = runner_.graph().passes[i];
      PassCounts counts;
      counts.pass = pass.name;
      counts.frequency = pass.frequency;
      double threads = 0.0, barriers = 0.0;
      for (const Step& step : steps_) {
        if (step.pass != i) continue;
        ++counts.steps;
        if (!step.counter.buffer) continue;
        const TexelCounts found = step.counter.buffer->counts();
        counts.fetches += sum(found.fetches) / pixels;
        counts.texels_written += sum(found.written) / pixels;
        counts.operations += sum(found.operations) / pixels;
        counts.bytes_read += sum(found.bytes_read) / pixels;
        counts.bytes_written += sum(found.bytes_written) / pixels;
        threads += found.invocations;
        barriers += static_cast<double>(found.barriers);
        add_per_pixel(step, found.fetches, pixels, result);
      }
      counts.invocations = threads / pixels;
      if (pass.kind == PassKind::compute) {
        const auto [x, y, z] = runner_.counting_[i].usual.workgroup_size();
        counts.groups = threads / (static_cast<double>(x) * y * z);
        counts.barriers_per_group = barriers / threads;
      }
      if (pass.frequency == techniques::Frequency::cascade || writes_over_map(pass))
        counts.fetches_per_cascade =
            counts.fetches * pixels / static_cast<double>(extents_.map.origins.size());
      result.passes.push_back(std::move(counts));
    }
  }

 private:
  void take_history(UniformValues& values, const Run* before) {
    for (const GraphTexture& texture : runner_.graph().textures) {
      if (texture.previous_of.empty()) continue;
      gpu::Image& to = resources_.texture(texture.name);
      for (int layer = 0; layer < to.shape().layers; ++layer) {
        std::vector<std::byte> content(to.size_bytes());
        if (before != nullptr)
          before->resources_.texture(texture.previous_of).download_bytes(content, {.layer = layer});
        to.upload_bytes(content, {.layer = layer});
      }
    }
    if (camera_ != nullptr) set_previous_screen(values, eyes(), before == nullptr ? eyes() : before->eyes());
  }

  std::array<const CameraImage*, 2> eyes() const {
    return {camera_, second_eye_ == nullptr ? camera_ : second_eye_};
  }

  struct Counter {
    std::optional<TexelCounter> buffer;  // set for counting modules
    int divisor = 0;  // pixels of the screen per cell of the grid of counts, each way; 0: one cell for all
  };

  struct Step {
    std::size_t pass = 0;
    gpu::Bindings bindings;
    UniformValues uniforms;  // uniforms of this step alone
    Counter counter;         // casters keep the counts of all their steps in the first one's
    const CastersOnDevice::Part* part = nullptr;  // set for casters
  };

  std::vector<double> times_of_passes(const std::vector<double>& times) const {
    std::vector<double> of_pass(runner_.graph().passes.size(), 0.0);
    for (std::size_t i = 0; i < times.size(); ++i) of_pass[pass_of_step_[i]] += times[i];
    return of_pass;
  }

  ProgramOnDevice& program(std::size_t pass, const CastersOnDevice::Part* part = nullptr) {
    Programs& programs = counting_ ? runner_.counting_[pass] : runner_.plain_[pass];
    const bool alpha_tested = part != nullptr && part->alpha_test && programs.alpha_tested;
    return alpha_tested ? *programs.alpha_tested : programs.usual;
  }
  const UniformNumbers& numbers() const {
    static const UniformNumbers none;
    return runner_.graph_.source.filter ? runner_.graph_.source.filter->numbers : none;
  }

  std::vector<float> texels(const std::string& name, int layer = 0) const {
    if (resources_.texture(name).format() != gpu::Format::r32f)
      throw InputError(runner_.graph().texture(name)->where,
                       "'" + name + "' is read back as visibility or mask, which are of format r8 or r32f");
    return resources_.texture(name).download<float>({.layer = layer});
  }

  bool writes_over_map(const GraphPass& pass) const {
    const GraphTexture* written = geometry_.first_written_texture(pass);
    return written != nullptr &&
           (written->extent == techniques::ExtentOf::map || written->extent == techniques::ExtentOf::tile);
  }

  void add_per_pixel(const Step& step, const std::vector<std::uint32_t>& fetches, double pixels,
                     GraphResult& result) const {
    if (step.counter.divisor == 1) {
      const std::vector<std::uint32_t> rows =
          camera_ == nullptr || runner_.graph().passes[step.pass].kind == PassKind::filter
              ? fetches
              : rows_from_top(fetches, camera_->width, camera_->rows);
      for (std::size_t i = 0; i < rows.size(); ++i) result.fetches[i] += rows[i];
      return;
    }
    result.fetches_of_others += sum(fetches) / pixels;
    if (step.counter.divisor > 1) {
      const auto area = static_cast<float>(step.counter.divisor * step.counter.divisor);
      const int width = (extents_.screen_width + step.counter.divisor - 1) / step.counter.divisor;
      add(result.fetches_of_others_at,
          at_each_pixel(fetches, width, step.counter.divisor, *camera_,
                        [area](std::uint32_t count) { return static_cast<float>(count) / area; }));
    } else {
      add(result.fetches_of_others_at,
          std::vector<float>(result.fetches.size(), static_cast<float>(sum(fetches) / pixels)));
    }
  }

  // Returns the bytes of a texel of everything that is bound, for a module that counts: as the manifest
  // declares a texture of the graph, or as the image is.
  UniformValues texel_bytes(const GraphPass& pass, const NamedResources& named) const {
    UniformValues values;
    if (!counting_) return values;
    const auto set = [&values](const std::string& shader_name, std::size_t bytes) {
      values.set(shaders::texel_bytes_uniform(shader_name), static_cast<int>(bytes));
    };
    const auto declared = [this](const std::string& name) {
      return static_cast<std::size_t>(
          techniques::find_texel_format(runner_.graph().texture(name)->format)->bytes);
    };
    for (const auto& [name, bound] : named.images) set(name, gpu::texel_bytes(bound.image->shape().format));
    for (const auto* names : {&pass.reads, &pass.writes})
      for (const auto& [shader_name, name] : *names) set(shader_name, declared(name));
    if (pass.filter)
      for (const std::string& argument : pass.filter->arguments)
        if (resources_.is_texture(argument)) set(techniques::argument_name(argument), declared(argument));
    if (!techniques::is_drawn(pass.kind)) return values;
    for (std::size_t i = 0; i < pass.writes.size(); ++i) {
      const std::string& name = pass.writes[i].second;
      const int samples = runner_.graph().texture(name)->samples;
      set("SV_Target" + std::to_string(i), declared(name) * static_cast<std::size_t>(samples));
    }
    return values;
  }

  // Returns the resources that every program may bind, and those of the graph that the pass names.
  NamedResources named_resources(const GraphPass& pass, int mip) {
    NamedResources named;
    for (const auto& [name, image] : frame_.images()) named.images[name] = {image};
    for (const auto& [name, image] : runner_.own_.images()) named.images[name] = {image};
    if (depth_) named.images["_CameraDepthTexture"] = {&*depth_};
    named.samplers = frame_.samplers();
    named.buffers = frame_.buffers();
    if (pass.filter && pass.kind == PassKind::filter)
      for (const std::string& argument : pass.filter->arguments)
        if (resources_.is_texture(argument))
          named.images[techniques::argument_name(argument)] = {&resources_.texture(argument)};
    for (const auto& [shader_name, name] : pass.reads) {
      const bool level_before = pass.each_mip && techniques::writes_to(pass, name);
      named.images[shader_name] = {
          &resources_.texture(name),
          level_before ? gpu::ImageRange{.first_mip = mip - 1, .mips = 1} : gpu::ImageRange{}};
    }
    if (pass.kind == PassKind::compute)
      for (const auto& [shader_name, name] : pass.writes)
        named.images[shader_name] = {&resources_.texture(name)};
    return named;
  }

  // Binds black for absent textures, as the renderer feature does. The program does not read them.
  void add_absent(const GraphPass& pass, const ProgramOnDevice& program, NamedResources& named) {
    for (const std::string& name : pass.absent) {
      const std::string lists = "'" + pass.name + "' lists '" + name + "' as absent, ";
      if (named.images.contains(name))
        throw InputError(pass.where, lists + "which every pass is given", "leave it out of \"absent\"");
      const auto is_read = [&name](const shaders::Resource& resource) {
        return resource.kind == shaders::ResourceKind::sampled_image && resource.name == name;
      };
      if (std::none_of(program.resources().begin(), program.resources().end(), is_read))
        throw InputError(pass.where, lists + "and its program reads no such texture",
                         "write what '" + pass.file + "' calls the texture, or leave it out");
      if (!black_) {
        black_.emplace(*runner_.device_, gpu::ImageShape{.format = gpu::Format::r32f,
                                                         .width = 1,
                                                         .height = 1,
                                                         .layers = second_eye_ == nullptr ? 1 : 2});
        for (int layer = 0; layer < black_->shape().layers; ++layer)
          black_->upload(std::vector<float>{0.0F}, {.layer = layer});
      }
      named.images[name] = {&*black_};
    }
  }

  // Adds inline samplers and those of the user's textures, by the names that the program has.
  void add_own_samplers(const ProgramOnDevice& program, NamedResources& named) {
    for (const shaders::Resource& resource : program.resources())
      if (resource.kind == shaders::ResourceKind::sampler && named.samplers.count(resource.name) == 0)
        if (const gpu::Sampler* own = runner_.own_.sampler(resource.name))
          named.samplers[resource.name] = own;
  }

  // The grid has one cell for each pixel of a target, or thread, that covers a fixed share of the screen;
  // otherwise one cell holds all counts.
  Counter counter_of(const GraphPass& pass, int mip) const {
    Counter counter;
    int width = 1, height = 1;
    if (pass.kind == PassKind::filter) {
      width = frame_.width();
      height = frame_.height();
      counter.divisor = 1;
    } else {
      const GraphTexture* like = pass.kind == PassKind::compute
                                     ? runner_.graph().texture(pass.groups.texels_of)
                                     : geometry_.first_written_texture(pass);
      if (like != nullptr && like->extent == techniques::ExtentOf::screen && mip == 0) {
        const int threads = pass.kind == PassKind::compute ? pass.groups.divisor : 1;
        counter.divisor = like->divisor * threads;
        width = (resources_.texture(like->name).width() + threads - 1) / threads;
        height = (resources_.texture(like->name).height() + threads - 1) / threads;
      }
    }
    if (counting_) counter.buffer.emplace(*runner_.device_, width, height);
    return counter;
  }

  void add_pass(std::size_t index) {
    const GraphPass& pass = runner_.graph().passes[index];
    const int cascades =
        pass.frequency == techniques::Frequency::cascade ? static_cast<int>(extents_.map.origins.size()) : 1;
    const GraphTexture* written = geometry_.first_written_texture(pass);
    if (pass.kind == PassKind::casters) {
      add_casters(index, cascades);
      return;
    }
    const int mips = pass.each_mip ? geometry_.mips(*written, cascades) : 1;
    for (int mip = pass.each_mip ? 1 : 0; mip < mips; ++mip)
      for (int cascade = 0; cascade < cascades; ++cascade) add_step(index, cascade, mip);
  }

  void add_step(std::size_t index, int cascade, int mip) {
    const GraphPass& pass = runner_.graph().passes[index];
    ProgramOnDevice& used = program(index);
    NamedResources named = named_resources(pass, mip);
    add_absent(pass, used, named);
    add_own_samplers(used, named);
    Counter counter = counter_of(pass, mip);
    if (counter.buffer) named.buffers[shaders::texel_counts_name] = &counter.buffer->buffer();
    UniformValues uniforms = geometry_.uniforms(pass, cascade, mip);
    uniforms.merge(texel_bytes(pass, named));
    steps_.push_back({index, used.bind(named), std::move(uniforms), std::move(counter)});
    gpu::Bindings& bindings = steps_.back().bindings;
    used.set_uniforms(bindings, {});  // a sequence wants everything bound; run() sets the values
    switch (pass.kind) {
      case PassKind::filter:
        add_filter(used, bindings);
        break;
      case PassKind::compute:
        used.dispatch(sequence_, bindings, geometry_.groups(pass, used.workgroup_size()));
        break;
      case PassKind::raster:
        used.draw(sequence_, bindings, geometry_.targets(pass, cascade, mip, frame_.atlas()),
                  geometry_.tile(pass, cascade, mip));
        break;
      case PassKind::casters:
        break;  // add_casters()
    }
  }

  // Adds a draw for each cascade and material of the pass's casters. The targets are empty before the first
  // draw.
  void add_casters(std::size_t index, int cascades) {
    const GraphPass& pass = runner_.graph().passes[index];
    if (frame_.casters() == nullptr)
      throw std::invalid_argument("a graph of casters needs those of the frame");
    if (pass.casters == techniques::DrawnCasters::volumes && !frame_.casters()->has_volumes())
      throw std::invalid_argument("a graph of shadow volumes needs those of the frame's casters");
    for (const auto& [shader_name, name] : pass.writes) sequence_.clear(resources_.texture(name), 0.0F);
    if (resources_.is_texture(pass.depth))
      sequence_.clear(resources_.texture(pass.depth), runner_.graph_.source.reversed_z ? 0.0F : 1.0F);
    Counter counter = counter_of(pass, 0);
    const gpu::Buffer* counts = counter.buffer ? &counter.buffer->buffer() : nullptr;
    for (int cascade = 0; cascade < cascades; ++cascade)
      for (const CastersOnDevice::Part& part : frame_.casters()->parts())
        if (part.casters == pass.casters) add_part(index, cascade, part, counts, std::exchange(counter, {}));
  }

  void require_other_textures(const GraphPass& pass, const ProgramOnDevice& used) const {
    if (pass.depth != techniques::shadow_map_name) return;
    const std::map<std::string, const gpu::Image*> given = frame_.images();
    for (const shaders::Resource& resource : used.resources())
      if (const auto image = given.find(resource.name);
          image != given.end() && image->second == &frame_.atlas())
        throw InputError(
            pass.where,
            "'" + pass.name + "' reads '" + resource.name + "', the shadow map that it is tested against",
            "read a copy, or leave out \"depth\"");
  }

  void add_part(std::size_t index, int cascade, const CastersOnDevice::Part& part, const gpu::Buffer* counts,
                Counter counter) {
    const GraphPass& pass = runner_.graph().passes[index];
    ProgramOnDevice& used = program(index, &part);
    require_other_textures(pass, used);
    NamedResources named = named_resources(pass, 0);
    named.images["_BaseMap"] = {&frame_.casters()->base_map(part)};
    named.samplers["sampler_BaseMap"] = &part.sampler;
    add_own_samplers(used, named);
    if (counts != nullptr) named.buffers[shaders::texel_counts_name] = counts;
    UniformValues uniforms = geometry_.uniforms(pass, cascade, 0);
    uniforms.merge(texel_bytes(pass, named));
    if (pass.frequency == techniques::Frequency::cascade)
      uniforms.merge(frame_.caster_uniforms(cascade));
    else if (camera_ != nullptr)
      uniforms.merge(FrameOnDevice::caster_uniforms(*camera_));
    else
      throw std::invalid_argument("casters that the camera sees need a camera");
    steps_.push_back({index, used.bind(named), std::move(uniforms), std::move(counter), &part});
    used.set_uniforms(steps_.back().bindings, {});
    gpu::VertexStreams streams;
    for (const std::string& semantic : used.vertex_inputs())
      streams.inputs.push_back(frame_.casters()->vertices(semantic, pass.casters));
    streams.indices = &part.indices;
    gpu::RasterTile tile = geometry_.tile(pass, cascade, 0);
    tile.vertex_count = part.index_count;
    used.draw(sequence_, steps_.back().bindings, geometry_.targets(pass, cascade, 0, frame_.atlas()), tile,
              streams);
  }

  // The filter runs once per receiver: as a compute shader, or as a user's function in a fragment shader over
  // the picture.
  void add_filter(ProgramOnDevice& used, const gpu::Bindings& bindings) {
    if (!used.is_raster()) {
      const auto groups = [&](int pixels, std::size_t axis) {
        return (static_cast<std::uint32_t>(pixels) + used.workgroup_size()[axis] - 1) /
               used.workgroup_size()[axis];
      };
      used.dispatch(sequence_, bindings, {groups(frame_.width(), 0), groups(frame_.height(), 1), 1});
      return;
    }
    picture_.emplace(*runner_.device_, gpu::Format::r32f, frame_.width(), frame_.height());
    used.draw(sequence_, bindings, {{&*picture_}, nullptr, 0.0F}, whole_of(*picture_));
  }

  GraphRunner& runner_;
  const FrameOnDevice& frame_;
  const CameraImage* camera_;
  const CameraImage* second_eye_;
  GraphExtents extents_;
  GraphResources resources_;
  PassGeometry geometry_;
  std::optional<gpu::Image> depth_;
  std::optional<gpu::Image> black_;    // bound in the place of absent textures
  std::optional<gpu::Image> picture_;  // its content means nothing
  gpu::Sequence sequence_;
  bool counting_;
  std::vector<Step> steps_;
  std::vector<std::size_t>
      pass_of_step_;  // the pass of each step of the sequence, whose steps include clears
  std::set<std::string> unset_;
};

GraphRunner::GraphRunner(const gpu::Device& device, CompiledGraph graph)
    : device_(&device),
      graph_(std::move(graph)),
      own_(device, graph_.source.filter ? graph_.source.filter->textures : std::vector<AdapterTexture>{}) {
  for (std::size_t i = 0; i < graph_.programs.size(); ++i) {
    plain_.push_back(made(i, ProgramOnDevice::Module::as_shipped));
    if (this->graph().passes[i].kind == PassKind::filter && graph_.source.filter)
      check_numbers_of(*graph_.source.filter, graph_.programs[i], plain_.back().usual);
  }
}

GraphRunner::Programs GraphRunner::made(std::size_t pass, ProgramOnDevice::Module module) const {
  const TargetFormats targets = target_formats(graph_.source, graph().passes[pass], shadow_map_);
  Programs programs{ProgramOnDevice(*device_, graph_.programs[pass], module, targets), std::nullopt};
  const auto alpha_tested = graph_.alpha_tested.find(pass);
  if (alpha_tested != graph_.alpha_tested.end())
    programs.alpha_tested.emplace(*device_, alpha_tested->second, module, targets);
  return programs;
}

void GraphRunner::add_times(const std::vector<double>& of_passes, GraphResult& result) const {
  result.time_ns.push_back(std::accumulate(of_passes.begin(), of_passes.end(), 0.0));
  if (!device_->info().has_timestamps) return;
  result.pass_times_ns.resize(of_passes.size());
  for (std::size_t i = 0; i < of_passes.size(); ++i) result.pass_times_ns[i].push_back(of_passes[i]);
}

void GraphRunner::fit_to(gpu::Format shadow_map) {
  if (shadow_map == shadow_map_) return;
  shadow_map_ = shadow_map;
  for (std::size_t i = 0; i < graph().passes.size(); ++i) {
    if (graph().passes[i].depth != techniques::shadow_map_name) continue;
    plain_[i] = made(i, ProgramOnDevice::Module::as_shipped);
    if (!counting_.empty()) counting_[i] = made(i, ProgramOnDevice::Module::counting);
  }
}

GraphResult GraphRunner::run(const FrameOnDevice& frame, const CameraImage* camera,
                             const RunOptions& options) {
  GraphResult result;
  fit_to(frame.atlas().format());
  Run plain(*this, frame, camera, options.second_eye, ProgramOnDevice::Module::as_shipped);
  std::vector<std::unique_ptr<Run>> earlier;
  if (graph().has_history())
    for (const EarlierFrame& given : options.earlier)
      earlier.push_back(std::make_unique<Run>(*this, *given.frame, given.camera, nullptr,
                                              ProgramOnDevice::Module::as_shipped));
  // Draws the frames before a frame of this noise, and returns the last; null without any.
  const auto draw_earlier = [&](int noise) {
    const Run* before = nullptr;
    noise -= static_cast<int>(earlier.size());
    for (const std::unique_ptr<Run>& run : earlier) {
      run->run(noise++, before);
      before = run.get();
    }
    return before;
  };
  const int frames = static_cast<int>(earlier.size()) + 1;
  const auto noise_of = [&](int seed) { return (options.first_seed + seed + 1) * frames - 1; };
  const int seeds = graph_.source.uses_noise ? options.noise_seeds : std::min(1, options.noise_seeds);
  const auto timed = [&] { return static_cast<int>(result.time_ns.size()) < options.timing_repeats; };
  for (int seed = 0; seed < seeds; ++seed) {
    const std::vector<double> times = plain.run(noise_of(seed), draw_earlier(noise_of(seed)));
    const bool kept = seed > 0 && options.warm_up_seconds == 0.0;  // the driver may compile in the first run
    if (kept && timed()) add_times(times, result);
    result.visibility.push_back(plain.visibility());
  }
  const std::chrono::duration<double> warm_up(timed() ? options.warm_up_seconds : 0.0);
  for (const auto start = std::chrono::steady_clock::now();
       std::chrono::steady_clock::now() - start < warm_up;)
    plain.run(0);
  while (timed()) add_times(plain.run(0), result);
  const auto add_facts = [&result](const Run& run) {
    result.masked_out = run.masked_out();
    result.unset_uniforms.assign(run.unset_uniforms().begin(), run.unset_uniforms().end());
  };
  if (seeds > 0) add_facts(plain);
  if (!options.count_fetches) return result;
  for (std::size_t i = counting_.size(); i < graph_.programs.size(); ++i)
    counting_.push_back(made(i, ProgramOnDevice::Module::counting));
  Run counted(*this, frame, camera, options.second_eye, ProgramOnDevice::Module::counting);
  counted.run(noise_of(0), draw_earlier(noise_of(0)));
  counted.add_counts(result);
  if (seeds > 0) return result;
  result.visibility.push_back(counted.visibility());
  add_facts(counted);
  return result;
}

}  // namespace penumbra::resolve
