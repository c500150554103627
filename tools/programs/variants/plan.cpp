#include "variants/plan.h"

#include <algorithm>
#include <map>
#include <utility>

#include "input/visible_text.h"

namespace penumbra::variants {
namespace {

constexpr std::size_t most_shown = 8;

struct Saving {
  std::string label;
  std::string pin;
  VariantCount left;
};

// Returns the --keywords term that fixes a set.
std::string pin_of(const KeywordSet& set) {
  const bool can_be_off = std::any_of(set.alternatives.begin(), set.alternatives.end(),
                                      [](const Keywords& alternative) { return alternative.empty(); });
  std::string pin;
  if (can_be_off) {
    for (const std::string& keyword : keywords_of(set)) pin += (pin.empty() ? "-" : " -") + keyword;
  } else {
    for (const std::string& keyword : set.alternatives.front()) pin += (pin.empty() ? "+" : " +") + keyword;
  }
  return pin;
}

// Returns the first set of each label.
std::map<std::string, std::size_t> sets_by_label(const PlannedProgram& program) {
  std::map<std::string, std::size_t> places;
  const std::vector<KeywordSet>& sets = program.space->sets();
  for (std::size_t i = 0; i < sets.size(); ++i) places.try_emplace(label_of(sets[i]), i);
  return places;
}

VariantCount total_of(const PlannedProgram& program) {
  VariantCount total;
  for (const hlsl::Stage stage : program.stages) total += program.space->variants(stage).count();
  return total * VariantCount(program.targets);
}

VariantCount total_without(const PlannedProgram& program, std::size_t set) {
  VariantCount total;
  for (const hlsl::Stage stage : program.stages) total += program.space->count_without(set, stage);
  return total * VariantCount(program.targets);
}

std::vector<Saving> savings(const std::vector<PlannedProgram>& programs, VariantCount total) {
  struct Candidate {
    std::string pin;
    std::map<std::size_t, VariantCount> left;  // by number of the program that has the set
  };
  std::map<std::string, Candidate> candidates;  // by label
  for (std::size_t i = 0; i < programs.size(); ++i) {
    for (const auto& [label, set] : sets_by_label(programs[i])) {
      const KeywordSet& declared = programs[i].space->sets()[set];
      if (declared.alternatives.size() < 2) continue;
      Candidate& candidate = candidates[label];
      if (candidate.pin.empty()) candidate.pin = pin_of(declared);
      candidate.left[i] = total_without(programs[i], set);
    }
  }
  std::vector<VariantCount> totals;
  for (const PlannedProgram& program : programs) totals.push_back(total_of(program));
  std::vector<Saving> result;
  for (const auto& [label, candidate] : candidates) {
    Saving saving{label, candidate.pin, {}};
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const auto own = candidate.left.find(i);
      saving.left += own == candidate.left.end() ? totals[i] : own->second;
    }
    if (saving.left < total || total.saturated()) result.push_back(std::move(saving));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Saving& a, const Saving& b) { return a.left < b.left; });
  return result;
}

std::string line_of(const ProgramPlan& program) {
  std::string line = "  " + visible_line(program.name);
  for (const StagePlan& stage : program.stages)
    line += std::string("   ") + hlsl::stage_name(stage.stage) + " " + text_of(stage.variants);
  return line + "\n";
}

std::string shortened(const std::string& text, std::size_t longest) {
  return text.size() <= longest ? text : text.substr(0, longest - 3) + "...";
}

}  // namespace

std::string results_text(VariantCount results) {
  return text_of(results) + (results == VariantCount(1) ? " result" : " results");
}

Plan plan(const std::vector<PlannedProgram>& programs) {
  Plan result;
  for (const PlannedProgram& program : programs) {
    ProgramPlan counted{program.name, {}, total_of(program)};
    for (const hlsl::Stage stage : program.stages)
      counted.stages.push_back({stage, program.space->variants(stage).count()});
    result.results += counted.results;
    result.programs.push_back(std::move(counted));
  }
  return result;
}

std::string text_of(const Plan& plan, const Plan& what_if, const std::string& condition) {
  const auto both = [](VariantCount count, VariantCount other) {
    return text_of(count) + " (" + text_of(other);
  };
  std::string text;
  for (std::size_t i = 0; i < plan.programs.size(); ++i) {
    const ProgramPlan& program = plan.programs[i];
    text += "  " + visible_line(program.name);
    for (std::size_t j = 0; j < program.stages.size(); ++j)
      text += std::string("   ") + hlsl::stage_name(program.stages[j].stage) + " " +
              both(program.stages[j].variants, what_if.programs.at(i).stages.at(j).variants) + ")";
    text += "\n";
  }
  return text + "  in all " + results_text(plan.results) + " (" + text_of(what_if.results) + " with " +
         condition + ")\n";
}

std::string text_of(const Plan& plan) {
  std::string text;
  for (const ProgramPlan& program : plan.programs) text += line_of(program);
  return text + "  in all " + results_text(plan.results) + "\n";
}

std::string refusal(const std::vector<PlannedProgram>& programs, std::uint64_t limit) {
  const Plan counted = plan(programs);
  if (counted.results.value() <= limit) return {};
  std::string text =
      results_text(counted.results) + " to compile; the limit is " + text_of(VariantCount(limit)) + "\n";
  std::vector<const ProgramPlan*> largest;
  for (const ProgramPlan& program : counted.programs) largest.push_back(&program);
  std::stable_sort(largest.begin(), largest.end(),
                   [](const ProgramPlan* a, const ProgramPlan* b) { return a->results > b->results; });
  text += "most of them in\n";
  for (std::size_t i = 0; i < std::min(largest.size(), most_shown); ++i) text += line_of(*largest[i]);
  if (largest.size() > most_shown)
    text += "  and " + std::to_string(largest.size() - most_shown) + " more programs\n";
  const std::vector<Saving> candidates = savings(programs, counted.results);
  if (!candidates.empty())
    text += "what multiplies the number most, and how many results are left without it\n";
  for (std::size_t i = 0; i < std::min(candidates.size(), most_shown); ++i) {
    const Saving& saving = candidates[i];
    text += "  " + text_of(saving.left) + " left   --keywords '" + shortened(saving.pin, 200) + "'\n";
  }
  return text +
         "narrow the keywords (+NAME always, -NAME never, A|B only these), pass a stripping file with what "
         "the project uses (URP settings, materials), compile only some variants of each entry point with "
         "--sample 3, or raise the limit\n";
}

}  // namespace penumbra::variants
