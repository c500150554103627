// A compiled subject, and its results for a case. Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reference/reference_cache.h"
#include "reference/visibility_image.h"
#include "resolve/graph_runner.h"
#include "study/case_setup.h"
#include "study/results.h"
#include "study/study.h"

namespace penumbra::study {

// The results of one subject for one case.
using Answer = resolve::GraphResult;

class PreparedSubject {
 public:
  // The subject must outlive the object.
  PreparedSubject(const gpu::Device& device, const Subject& subject, const StudySettings& settings);

  const Subject& subject() const { return *subject_; }

  // Returns a hash of this program, the device, and the subject with its graph as it was compiled.
  const std::string& key() const { return key_; }

  Answer answer(const FrameOfCase& frame, const resolve::RunOptions& options);

  // Returns the answer with unlimited samples; absent where the subject takes none, or where the settings
  // want no such answer.
  std::optional<reference::VisibilityImage> unlimited_answer(const CaseSetup& setup, const View& view,
                                                             const reference::ReferenceCache& cache);

  // Returns the frames that the view's is preceded by, of a subject with history.
  std::vector<resolve::EarlierFrame> earlier_frames(const View& view) const;

  // With history there is no static noise.
  Shimmer shimmer(const CaseSetup& setup, const View& view);

 private:
  PreparedSubject(const gpu::Device& device, const Subject& subject, const StudySettings& settings,
                  resolve::CompiledGraph graph);

  const Subject* subject_;
  std::string key_;
  resolve::GraphRunner runner_;
  std::string unlimited_key_;  // the key of the graph with unlimited samples
  std::optional<resolve::GraphRunner> unlimited_runner_;
};

std::vector<float> mean_image(const std::vector<std::vector<float>>& images);

}  // namespace penumbra::study
