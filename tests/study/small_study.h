// A study of the library's techniques that a test can wait for: one scene and light, few rays and one noise.
#pragma once

#include "reference/scratch_folder.h"
#include "resolve/test_device.h"
#include "study/study.h"

namespace penumbra::study {

inline Subject library_subject(const std::string& technique) {
  return technique_subject(library_techniques(), library_techniques().find(technique), true);
}

inline std::vector<Subject> library_subjects(const std::vector<std::string>& names) {
  std::vector<Subject> subjects;
  for (const std::string& name : names) subjects.push_back(library_subject(name));
  return subjects;
}

// Its results are kept in its own folder; as of most, times and the parts of the error are not measured.
struct SmallStudy {
  SmallStudy(const scene::Scene& scene, double light_degrees, int width, int height) {
    settings.scenes = {scene};
    settings.light_degrees = {light_degrees};
    settings.frame.width = width;
    settings.frame.height = height;
    settings.frame.shadows.cascades = 4;
    settings.reference_samples = 64;
    settings.noise_seeds = 1;
    settings.timing_repeats = 0;
    settings.split_error = false;
    settings.cache = cache.path();
  }

  StudyOutcome run(const std::vector<Subject>& subjects) const {
    return run_study(test_device(), subjects, settings, [](auto&&...) {});
  }

  // Returns the records by technique. The study must have no notes.
  std::map<std::string, Record> records(const std::vector<Subject>& subjects) const {
    const StudyOutcome outcome = run(subjects);
    EXPECT_TRUE(outcome.notes.empty()) << outcome.notes.front();
    std::map<std::string, Record> records;
    for (const Record& record : outcome.records) records[record.technique] = record;
    return records;
  }

  reference::ScratchFolder cache;
  StudySettings settings;
};

}  // namespace penumbra::study
