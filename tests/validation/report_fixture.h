// Reports made by hand, which the tests of the forms look at.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "validation/report.h"

namespace penumbra::validation {

inline hlsl::Diagnostic error_at(std::string file, int line, int column, std::string message) {
  return {std::move(file), line, column, hlsl::Severity::error, std::move(message), {}};
}

// A variant of Assets/Water.shader's ForwardLit that passed.
inline VariantRecord water(std::vector<std::string> keywords, std::string target = "spirv") {
  VariantRecord record;
  record.file = "Assets/Water.shader";
  record.shader = "Custom/Water";
  record.pass = "ForwardLit";
  record.entry = "Frag";
  record.stage = hlsl::Stage::fragment;
  record.keywords = std::move(keywords);
  record.target = std::move(target);
  return record;
}

inline VariantRecord failed(VariantRecord record, hlsl::Diagnostic diagnostic) {
  record.status = VariantStatus::failed;
  record.diagnostics.push_back(std::move(diagnostic));
  return record;
}

// Every subset of the keywords, the smallest number first.
inline std::vector<std::vector<std::string>> subsets(const std::vector<std::string>& keywords) {
  std::vector<std::vector<std::string>> sets;
  for (std::size_t bits = 0; bits < (std::size_t{1} << keywords.size()); ++bits) {
    std::vector<std::string> set;
    for (std::size_t i = 0; i < keywords.size(); ++i)
      if ((bits >> i & 1U) != 0) set.push_back(keywords[i]);
    sets.push_back(std::move(set));
  }
  return sets;
}

// The report has something of everything: two causes, a lint finding, notes, a crash, absences, text no form
// may break on.
inline ValidationReport mixed_report() {
  ValidationReport report;
  hlsl::Diagnostic shared = error_at("Assets/Water.hlsl", 12, 17, "unknown variable 'depth'");
  shared.source_line = "    return depth * 2.0;";
  for (const std::vector<std::string>& keywords : subsets({"_FOAM", "_SHADOWS_SOFT"})) {
    const bool soft = !keywords.empty() && keywords.back() == "_SHADOWS_SOFT";
    report.records.push_back(soft ? failed(water(keywords), shared) : water(keywords));
    report.records.push_back(water(keywords, "msl23"));
    if (soft) report.records.back().status = VariantStatus::unreached;
  }
  VariantRecord emitted =
      failed(water({"_WAVES"}, "essl310"), {"essl310", 40, 3, hlsl::Severity::error, "`x' undeclared", {}});
  report.records.push_back(emitted);
  VariantRecord crash = water({"_CRASH"});
  crash = failed(crash, error_at("Assets/Water.shader", 0, 0, "glslang crashed (signal 11)"));
  crash.diagnostics[0].rule = compiler_crash;
  crash.reproduction = "build/crashes/1a2b.hlsl";
  report.records.push_back(crash);
  VariantRecord lint = water({"_LINT"});
  lint.diagnostics = {{"Assets/Water.shader", 30, 5, hlsl::Severity::warning, "'colour' is <unset> & \"odd\"",
                       "    return colour;", "unset-output"},
                      {"Assets/Water.shader", 31, 1, hlsl::Severity::note, "kept the body of float", {}}};
  report.records.push_back(lint);
  VariantRecord unchecked = water({"_GRASS"});
  unchecked.status = VariantStatus::unchecked;
  unchecked.reason = "needs HLSLSupport.cginc, which comes with the Unity editor alone; give --cginc-root";
  report.records.push_back(unchecked);
  VariantRecord strange =
      failed(water({"caf\xE9"}), error_at("Assets/na\xC3\xAFve dir/a,b:c.hlsl", 1, 1,
                                          "byte \xFF, control \x01, ]]> % \r\nand a second line"));
  report.records.push_back(strange);
  report.unique = 5;
  report.seconds = 1.25;
  report.checks = {{"essl310", "OpenGL ES 3.2"}};
  report.rules = {{"unset-output", "An output is unset on some path"}};
  return report;
}

}  // namespace penumbra::validation
