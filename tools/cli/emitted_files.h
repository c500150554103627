// The files that `penumbra validate` writes from the techniques' manifests instead of validating.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "techniques/technique_list.h"

namespace penumbra::cli {

// Each is a file, with - for standard output, except two that are folders; empty means not requested.
struct EmittedFiles {
  std::string parameters;  // a folder
  std::string graphs;      // a folder
  std::string presets;
  std::string looks;
  std::string keywords;
  std::string selections;
  std::string options;
  std::string techniques;
  std::string packing;
  std::string programs;

  bool any() const;
};

void add_emitted_options(CLI::App& command, EmittedFiles& files);
// Throws InputError where one cannot be written, or is the technique list that is read.
void check_emitted(const EmittedFiles& files, const std::string& technique_list);
void write_emitted(const EmittedFiles& files, const techniques::TechniqueList& list);

}  // namespace penumbra::cli
