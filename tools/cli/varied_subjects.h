// What `render` shows: every technique with every value of its varied parameters, then every adapter.
#pragma once

#include <string>
#include <vector>

#include "cli/study_options.h"
#include "study/study.h"

namespace penumbra::cli {

struct VariedSubjects {
  std::vector<std::string>
      set;                  // NAME=V1[,V2...]: parameters of all techniques; several vary with each other
  std::vector<int> frames;  // averaged; empty: 1
};

// Titles are captions: of one technique alone what varies, else the names, too. Throws InputError for an
// unknown technique, a parameter that a technique lacks, a value out of its range or no number, and whatever
// would stand twice.
std::vector<study::Subject> varied_subjects(const StudyOptions& options, const VariedSubjects& varied);

}  // namespace penumbra::cli
