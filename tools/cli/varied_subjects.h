// The subjects that `render` shows and `measure` measures: every technique with every value of its varied
// parameters, then every adapter.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cli/study_options.h"
#include "study/study.h"

namespace penumbra::cli {

struct VariedSubjects {
  std::vector<std::string> set;  // [TECHNIQUE:]NAME=V1[,V2...]: parameters of all techniques, or of that one,
                                 // which then does not take those of all; several vary with each other
  std::vector<int> frames;       // averaged; empty: 1
  std::vector<double> histories;  // shares of the newest frame, tried one by one; empty: 1
  bool captions = true;  // titles are captions of pictures; else a technique's own title and what was set
  std::vector<std::string> titles{};  // NAME=TEXT: titles of subjects, by their name
  std::string adapters = "last";      // "last" or "first": their position among the techniques
};

// Removes duplicates; the first occurrence keeps its position.
template <typename Value>
void drop_repetitions(std::vector<Value>& values) {
  std::vector<Value> once;
  for (const Value& value : values) {
    if (std::find(once.begin(), once.end(), value) == once.end()) once.push_back(value);
  }
  values = std::move(once);
}

void add_set_option(CLI::App& command, const std::string& group, VariedSubjects& varied);
void add_title_option(CLI::App& command, const std::string& group, VariedSubjects& varied);

// Names are distinct: the technique's, with the settings that were made. For one technique under several
// settings, captions are the settings that vary; otherwise they are the short title and
// the settings that were made. Without a technique and an adapter, the subject is pcss-angular-24-16.
// Throws InputError for an unknown technique, a parameter that a technique
// lacks, a value that is out of its range or no number, a title of what is not there, and two adapters of one
// name.
std::vector<study::Subject> varied_subjects(const StudyOptions& options, const VariedSubjects& varied);

}  // namespace penumbra::cli
