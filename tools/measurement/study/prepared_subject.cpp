#include "study/prepared_subject.h"

#include "platform/build_identity.h"
#include "platform/hashed_fields.h"
#include "study/metrics.h"

namespace penumbra::study {
namespace {

constexpr int kUnlimitedSeeds = 4;  // rotations averaged: with thousands of taps they have little effect

// Describes the device and this program, for the keys of results.
std::string machine_of(const gpu::Device& device) {
  return platform::hash_of(platform::build_identity(), device.info());
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
    : subject_(&subject),
      key_(platform::hash_of(machine_of(device), subject, graph)),
      runner_(device, std::move(graph)) {
  if (!settings.split_error || !subject.unlimited) return;
  resolve::CompiledGraph unlimited = resolve::compile(*subject.unlimited, settings.compiler);
  unlimited_key_ = platform::hash_of(machine_of(device), unlimited, kUnlimitedSeeds);
  unlimited_runner_.emplace(device, std::move(unlimited));
}

Answer PreparedSubject::answer(const FrameOfCase& frame, const resolve::RunOptions& options) {
  return runner_.run(frame.on_device, frame.camera ? &*frame.camera : nullptr, options);
}

std::optional<reference::VisibilityImage> PreparedSubject::unlimited_answer(
    const CaseSetup& setup, const View& view, const reference::ReferenceCache& cache) {
  if (!unlimited_runner_) return std::nullopt;
  const resolve::FrameOnDevice& frame = view.on_device_frame.on_device;
  const std::string key = platform::hash_of(view.key, unlimited_key_);
  if (std::optional<reference::VisibilityImage> kept = cache.find(key)) return kept;
  resolve::RunOptions options;
  options.noise_seeds = kUnlimitedSeeds;
  options.timing_repeats = 0;
  reference::VisibilityImage answer;
  answer.width = frame.width();
  answer.height = frame.height();
  answer.visibility = mean_image(unlimited_runner_->run(frame, options).visibility);
  answer.valid = setup.t1.valid;
  answer.samples = kUnlimitedSeeds;
  cache.store(key, answer);
  return answer;
}

std::vector<resolve::EarlierFrame> PreparedSubject::earlier_frames(const View& view) const {
  std::vector<resolve::EarlierFrame> frames;
  if (!runner_.graph().has_history()) return frames;
  for (const FrameOfCase& frame : view.earlier) frames.push_back({&frame.on_device, &*frame.camera});
  return frames;
}

Shimmer PreparedSubject::shimmer(const CaseSetup& setup, const View& view) {
  const bool has_history = runner_.graph().has_history();
  const auto of = [&](bool noise_moves) {
    std::vector<std::vector<float>> pictures;
    resolve::RunOptions options{.noise_seeds = 1, .timing_repeats = 0, .earlier = earlier_frames(view)};
    for (std::size_t k = 0; k < view.pan.size(); ++k) {
      options.first_seed = noise_moves && !has_history ? static_cast<int>(k) : 0;
      pictures.push_back(answer(view.pan[k], options).visibility.front());
      if (has_history) options.earlier.push_back({&view.pan[k].on_device, &*view.pan[k].camera});
    }
    return shimmer_of(pictures, setup.t1.width, setup.t1.visibility, setup.t1.valid);
  };
  return {static_cast<int>(view.pan.size()), has_history ? std::nullopt : of(false), of(true)};
}

}  // namespace penumbra::study
