#include "study/prepared_subject.h"

#include "platform/content_hash.h"
#include "study/shimmer.h"

namespace penumbra::study {
namespace {

// Version of what is stored under unlimited_key: raise it when the meaning of T3 changes.
constexpr int kUnlimitedVersion = 1;
constexpr int kUnlimitedSeeds = 4;  // rotations averaged: with thousands of taps they have little effect

// Bytecode's modules do not say which uniform is where.
void add_uniforms(platform::ContentHash& hash, const resolve::CompiledProgram& program) {
  for (const auto* blocks : {&program.vertex_uniforms, &program.uniforms})
    for (const shaders::Resource& block : *blocks)
      for (const shaders::UniformMember& member : block.members)
        hash.update(block.name).update(member.name).update(member.offset);
}

void add_to(platform::ContentHash& hash, const resolve::CompiledGraph& graph) {
  for (const resolve::CompiledProgram& program : graph.programs) {
    hash.update(std::span<const std::uint32_t>(program.plain));
    add_uniforms(hash, program);
  }
  hash.update(graph.source.parameters.fingerprint());
}

std::string unlimited_key(const View& view, const resolve::CompiledGraph& graph) {
  platform::ContentHash hash;
  hash.update(kUnlimitedVersion).update(view.key);
  add_to(hash, graph);
  return hash.hex();
}

// Of all that a record says of its subject, and what its programs read besides the frame.
std::string fingerprint_of(const Subject& subject, const resolve::CompiledGraph& graph) {
  platform::ContentHash hash;
  hash.update(subject.name).update(subject.title).update(subject.averaged_frames).update(subject.history);
  hash.update(subject.light_scale).update(subject.cascades.size());
  for (const techniques::CascadeRule& rule : subject.cascades) {
    hash.update(rule.from).update(rule.technique);
    for (const auto& [name, values] : rule.values) {
      hash.update(name);
      for (const double value : values) hash.update(value);
    }
  }
  add_to(hash, graph);
  for (const auto& [pass, program] : graph.alpha_tested)
    hash.update(pass).update(std::span<const std::uint32_t>(program.plain));
  for (const techniques::GraphTexture& texture : graph.source.graph.textures)
    hash.update(texture.name).update(texture.format).update(texture.divisor).update(texture.mips);
  return hash.hex();
}

}  // namespace

std::vector<float> mean_image(const std::vector<std::vector<float>>& images) {
  std::vector<float> mean(images.front().size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double sum = 0.0;
    for (const std::vector<float>& image : images) sum += image[i];
    mean[i] = static_cast<float>(sum / static_cast<double>(images.size()));
  }
  return mean;
}

PreparedSubject::PreparedSubject(const gpu::Device& device, const Subject& subject,
                                 const StudySettings& settings)
    : PreparedSubject(device, subject, settings, resolve::compile(subject.graph, settings.compiler)) {}

PreparedSubject::PreparedSubject(const gpu::Device& device, const Subject& subject,
                                 const StudySettings& settings, resolve::CompiledGraph graph)
    : subject_(&subject), fingerprint_(fingerprint_of(subject, graph)), runner_(device, std::move(graph)) {
  if (settings.split_error && subject.unlimited) {
    unlimited_ = resolve::compile(*subject.unlimited, settings.compiler);
    unlimited_runner_.emplace(device, *unlimited_);
  }
}

Answer PreparedSubject::answer(const FrameOfCase& frame, const resolve::RunOptions& options) {
  return runner_.run(frame.on_device, frame.camera ? &*frame.camera : nullptr, options);
}

std::optional<reference::VisibilityImage> PreparedSubject::unlimited_answer(
    const CaseSetup& setup, const View& view, const reference::ReferenceCache& cache) {
  if (!unlimited_) return std::nullopt;
  const resolve::FrameOnDevice& frame = view.on_device_frame.on_device;
  const std::string key = unlimited_key(view, *unlimited_);
  if (std::optional<reference::VisibilityImage> kept = cache.find(key)) return kept;
  resolve::RunOptions options;
  options.noise_seeds = kUnlimitedSeeds;
  options.timing_repeats = 0;
  options.count_fetches = false;
  reference::VisibilityImage answer;
  answer.width = frame.width();
  answer.height = frame.height();
  answer.visibility = mean_image(unlimited_runner_->run(frame, options).visibility);
  answer.valid = setup.t1.valid;
  answer.samples = kUnlimitedSeeds;
  cache.store(key, answer);
  return answer;
}

Shimmer PreparedSubject::shimmer(const CaseSetup& setup, const std::vector<FrameOfCase>& pan) {
  const auto of = [&](bool noise_moves) {
    std::vector<std::vector<float>> pictures;
    for (std::size_t k = 0; k < pan.size(); ++k) {
      resolve::RunOptions options{.noise_seeds = 1, .timing_repeats = 0, .count_fetches = false};
      options.first_seed = noise_moves ? static_cast<int>(k) : 0;
      pictures.push_back(answer(pan[k], options).visibility.front());
    }
    return shimmer_of(pictures, setup.t1.width, setup.t1.visibility, setup.t1.valid);
  };
  return {static_cast<int>(pan.size()), of(false), of(true)};
}

}  // namespace penumbra::study
