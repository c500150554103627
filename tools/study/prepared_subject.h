// A subject compiled, and what it answers in a case. Internal to this room.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "reference/reference_cache.h"
#include "reference/visibility_image.h"
#include "resolve/resolve.h"
#include "resolve/screen_chain.h"
#include "resolve/shadow_shader.h"
#include "shaders/package_shader.h"
#include "study/case_setup.h"
#include "study/results.h"
#include "study/study.h"

namespace penumbra::study {

// What one subject answers in one case.
struct Answer {
  resolve::ResolveResult image;
  double fetches_of_others = 0.0;           // of passes at lower resolution, per pixel
  std::vector<float> fetches_of_others_at;  // the same at each pixel; empty without such passes
  std::vector<std::uint8_t> masked_out;
};

class PreparedSubject {
 public:
  // The subject has to outlive it. `package` is asked for by passes over the screen alone.
  PreparedSubject(const gpu::Device& device, const Subject& subject, const StudySettings& settings,
                  const std::function<const shaders::PackageShader&()>& package);

  const Subject& subject() const { return *subject_; }

  Answer answer(const FrameOfCase& frame, const resolve::ResolveOptions& options);

  // With unlimited samples; absent where it takes none, or where the settings want no such answer.
  std::optional<reference::VisibilityImage> unlimited_answer(const CaseSetup& setup, const View& view,
                                                             const reference::ReferenceCache& cache);

  Shimmer shimmer(const CaseSetup& setup, const std::vector<FrameOfCase>& pan);

 private:
  const Subject* subject_;
  std::optional<resolve::Resolver> resolver_;  // this or
  std::optional<resolve::ScreenChain> chain_;  // that
  std::optional<resolve::CompiledShadowShader> unlimited_;
  std::optional<resolve::Resolver> unlimited_resolver_;
};

std::vector<float> mean_image(const std::vector<std::vector<float>>& images);

}  // namespace penumbra::study
