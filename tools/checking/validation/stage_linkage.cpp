#include "validation/stage_linkage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "hlsl/source_text.h"
#include "hlsl/stage.h"
#include "lint/interpolated_cascade.h"
#include "lint/suppression.h"
#include "validation/spirv_target.h"
#include "validation/unit_lint.h"

namespace penumbra::validation {

namespace {

using hlsl::Stage;
using shaders::Signature;
using shaders::SignatureElement;
using shaders::SignatureType;
using Names = std::set<std::string>;

constexpr std::array order{Stage::vertex, Stage::hull, Stage::domain, Stage::geometry, Stage::fragment};

// The variants of one program, by stage.
using Stages = std::map<Stage, std::vector<std::size_t>>;

// A vertex and a fragment program, or two other stages one after the other.
struct Neighbours {
  const std::vector<std::size_t>* before = nullptr;
  const std::vector<std::size_t>* after = nullptr;
};

std::vector<Neighbours> neighbours(const Stages& stages) {
  std::vector<Neighbours> list;
  const std::vector<std::size_t>* before = nullptr;
  for (const Stage stage : order) {
    const auto found = stages.find(stage);
    if (found == stages.end()) continue;
    if (before != nullptr) list.push_back({before, &found->second});
    before = &found->second;
  }
  return list;
}

Names keywords_of(const std::vector<CompileUnit>& units, const std::vector<std::size_t>& variants) {
  Names names;
  for (const std::size_t variant : variants)
    names.insert(units[variant].keywords.begin(), units[variant].keywords.end());
  return names;
}

Names common(const Names& a, const Names& b) {
  Names both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

using StagePair = std::pair<std::size_t, std::size_t>;  // the stage before and the stage after
using StagePairs = std::vector<StagePair>;

// A keyword that both stages have is on in both or in neither. Where stage-specific keywords become those of
// all stages, variants with one are compiled here without it in the other stage, and cannot be compared.
void add_pairs(const std::vector<CompileUnit>& units, const Neighbours& stages, StagePairs& pairs) {
  const Names shared = common(keywords_of(units, *stages.before), keywords_of(units, *stages.after));
  const auto key = [&](std::size_t variant) {
    return common(shared, Names(units[variant].keywords.begin(), units[variant].keywords.end()));
  };
  std::map<Names, std::vector<std::size_t>> before;
  for (const std::size_t variant : *stages.before) before[key(variant)].push_back(variant);
  for (const std::size_t after : *stages.after)
    for (const std::size_t fits : before[key(after)])
      if (units[after].stage_keywords || keywords_of(units, {fits}) == keywords_of(units, {after}))
        pairs.emplace_back(fits, after);
}

// Returns the variants by CompileUnit::program.
std::map<int, Stages> programs_of(const std::vector<CompileUnit>& units) {
  std::map<int, Stages> programs;
  for (std::size_t i = 0; i < units.size(); ++i)
    if (units[i].program >= 0) programs[units[i].program][units[i].compile.stage].push_back(i);
  return programs;
}

// The instance's number is a value of the system for vertex programs alone: others read what is written to
// it.
bool is_system_value(const SignatureElement& element) {
  return element.semantic.starts_with("SV_") && element.semantic != "SV_INSTANCEID";
}

// These are values of the rasteriser by their names in Direct3D 9, which Unity's compilers still take.
bool is_generated(const SignatureElement& element, Stage stage) {
  return stage == Stage::fragment && (element.semantic == "VFACE0" || element.semantic == "VPOS0");
}

// Returns "TEXCOORD3" for the second of TEXCOORD2.
std::string semantic_of(const SignatureElement& element, int number) {
  const std::size_t digits = element.semantic.find_last_not_of("0123456789") + 1;
  const std::string index = element.semantic.substr(digits);
  if (index.empty() || index.size() > 6) return element.semantic;
  return element.semantic.substr(0, digits) + std::to_string(std::stoi(index) + number);
}

const SignatureElement* writer_of(const Signature& signature, const SignatureElement& input, int number) {
  const std::string semantic = semantic_of(input, number);
  for (const SignatureElement& element : signature) {
    if (!element.output || element.per_patch != input.per_patch) continue;
    for (int i = 0; i < element.count; ++i)
      if (semantic_of(element, i) == semantic) return &element;
  }
  return nullptr;
}

std::string type_name(const SignatureElement& element) {
  std::string name = element.type == SignatureType::floating         ? "float"
                     : element.type == SignatureType::signed_integer ? "int"
                                                                     : "uint";
  return element.components > 1 ? name + std::to_string(element.components) : name;
}

std::string place_of(const SignatureElement& element) {
  return element.line > 0 ? " (" + element.file + ":" + std::to_string(element.line) + ")" : "";
}

std::string program_name(const CompileUnit& unit) {
  return std::string("the ") + hlsl::stage_name(unit.compile.stage) + " program '" + unit.compile.entry + "'";
}

// Returns " with A B": the keywords that the other stage does not have.
std::string own_keywords(const CompileUnit& unit, const CompileUnit& other) {
  std::string own;
  for (const std::string& keyword : unit.keywords)
    if (std::find(other.keywords.begin(), other.keywords.end(), keyword) == other.keywords.end())
      own += (own.empty() ? " with " : " ") + keyword;
  return own.empty() ? " without further keywords" : own;
}

// Says why the value of the stage before is not what the input is declared as; empty if it is.
std::string mismatch(const SignatureElement& input, const SignatureElement& written, int number,
                     const std::string& writer, Stage reader) {
  const bool typed = input.type != SignatureType::other && written.type != SignatureType::other;
  const bool fewer = input.components > 0 && written.components > 0 && written.components < input.components;
  if (!typed || (input.type == written.type && !fewer)) return {};
  return "'" + semantic_of(input, number) + "' is " + type_name(input) + " in the " +
         hlsl::stage_name(reader) + " program, but " + writer + " writes " + type_name(written) +
         place_of(written);
}

// A problem of an input, with the variants of the stage before that do not fit it.
struct Misfit {
  std::string message;
  const SignatureElement* input = nullptr;
  int number = 0;
  std::vector<const UnitResult*> writers;
};

class Linkage {
 public:
  explicit Linkage(const std::vector<CompileUnit>& units) : units_(units) {}

  // `before` has every variant of the stage before that it may run with.
  void check(const std::vector<const UnitResult*>& before, UnitResult& after) {
    const CompileUnit& reader = units_[after.unit];
    std::vector<Misfit> misfits;
    for (const UnitResult* writer : before) {
      add_misfits(*writer, after, misfits);
      lint_cascades(*writer, after);
    }
    for (const Misfit& misfit : misfits) {
      const UnitResult& writer = *misfit.writers.front();
      const bool with_all = misfit.writers.size() == before.size();
      add(after, misfit.input->file, misfit.input->line, misfit.input->written,
          with_all ? misfit.message
                   : problem_of(writer, *misfit.input, misfit.number,
                                program_name(units_[writer.unit]) + own_keywords(units_[writer.unit], reader),
                                reader.compile.stage));
    }
  }

  // Checks the stage before the fragment program.
  void check_position(UnitResult& result) {
    const CompileUnit& unit = units_[result.unit];
    const Signature& signature = signature_of(result);
    const auto writes = [&](const char* semantic) {
      return std::any_of(signature.begin(), signature.end(), [&](const SignatureElement& element) {
        return element.output && element.semantic == semantic;
      });
    };
    if (writes("SV_POSITION")) return;
    add(result, {}, 0, {},
        program_name(unit) + " writes no SV_Position, so nothing is drawn" +
            (writes("POSITION0") ? ": write SV_Position in place of POSITION, Direct3D 9's name" : ""));
  }

 private:
  const Signature& signature_of(const UnitResult& result) {
    const auto [known, is_new] = signatures_.try_emplace(result.signature.get());
    if (is_new && result.signature) known->second = decode_signature(*result.signature).value_or(Signature{});
    return known->second;
  }

  std::string problem_of(const UnitResult& before, const SignatureElement& input, int number,
                         const std::string& writer, Stage reader) {
    const SignatureElement* written = writer_of(signature_of(before), input, number);
    if (written != nullptr) return mismatch(input, *written, number, writer, reader);
    return std::string("the ") + hlsl::stage_name(reader) + " program reads '" + semantic_of(input, number) +
           "', which " + writer + " does not write";
  }

  // Adds the first misfit of each input.
  void add_misfits(const UnitResult& before, const UnitResult& after, std::vector<Misfit>& misfits) {
    const std::pair signatures(before.signature.get(), after.signature.get());
    if (fitting_.count(signatures) != 0) return;
    const Stage reader = units_[after.unit].compile.stage;
    bool fits = true;
    for (const SignatureElement& input : signature_of(after)) {
      if (input.output || !input.read || is_system_value(input) || is_generated(input, reader)) continue;
      for (int i = 0; i < input.count; ++i) {
        const std::string problem = problem_of(before, input, i, program_name(units_[before.unit]), reader);
        if (problem.empty()) continue;
        fits = false;
        auto known = std::find_if(misfits.begin(), misfits.end(),
                                  [&](const Misfit& misfit) { return misfit.message == problem; });
        if (known == misfits.end()) known = misfits.insert(known, {problem, &input, i, {}});
        known->writers.push_back(&before);
        break;
      }
    }
    if (fits) fitting_.insert(signatures);
  }

  void lint_cascades(const UnitResult& before, UnitResult& after) {
    const CompileUnit& reader = units_[after.unit];
    if (reader.compile.stage != Stage::fragment) return;
    for (const SignatureElement& input : signature_of(after)) {
      const SignatureElement* written = input.read ? writer_of(signature_of(before), input, 0) : nullptr;
      if (written == nullptr || !written->of_cascade) continue;
      const std::string source_line = input.line > 0 ? line_of(input.file, input.line) : "";
      hlsl::Diagnostic finding =
          lint::interpolated_cascade_finding({input.line > 0 ? input.file : reader.file, input.line,
                                              hlsl::column_in(source_line, input.written, 0, 1)},
                                             input.semantic, program_name(units_[before.unit]));
      finding.source_line = source_line;
      std::vector<hlsl::Diagnostic>& said = speaker_of(after).diagnostics;
      for (hlsl::Diagnostic& kept :
           wanted(lint::without_suppressed({std::move(finding)}, sources_), reader.lint))
        if (std::find(said.begin(), said.end(), kept) == said.end()) said.push_back(std::move(kept));
    }
  }

  // Without a line, the message is at the #pragma that names the entry point.
  void add(UnitResult& result, const std::string& file, int line, const std::string& word,
           const std::string& message) {
    const CompileUnit& unit = units_[result.unit];
    hlsl::TokenPlace place{file, line, 0};
    if (line == 0) place = unit.compile.entry_place;
    hlsl::Diagnostic diagnostic{place.line > 0 ? place.file : unit.file,
                                place.line,
                                place.column,
                                hlsl::Severity::error,
                                message,
                                {}};
    if (place.line > 0) diagnostic.source_line = line_of(place.file, place.line);
    if (line > 0) diagnostic.column = hlsl::column_in(diagnostic.source_line, word, 0, 1);
    TargetResult& target = speaker_of(result);
    target.diagnostics.push_back(std::move(diagnostic));
    target.status = VariantStatus::failed;
  }

  TargetResult& speaker_of(UnitResult& result) const {
    const std::vector<std::string>& targets = units_[result.unit].targets;
    const auto spirv = std::find_if(targets.begin(), targets.end(), is_spirv_target);
    return result.targets[spirv == targets.end() ? 0 : static_cast<std::size_t>(spirv - targets.begin())];
  }

  std::string line_of(const std::string& file, int line) {
    if (!sources_.contains(file)) sources_.add(file, hlsl::read_source(file).text);
    return sources_.line(file, line);
  }

  const std::vector<CompileUnit>& units_;
  std::map<const std::string*, Signature> signatures_;
  std::set<std::pair<const std::string*, const std::string*>> fitting_;
  hlsl::SourceFiles sources_;
};

// The results of a shard by unit, with those of other shards that its stages are compared with.
class Results {
 public:
  explicit Results(std::vector<UnitResult>& own) {
    for (UnitResult& result : own) all_[result.unit] = &result;
  }

  UnitResult* of(std::size_t unit) const {
    const auto found = all_.find(unit);
    return found == all_.end() || !found->second->signature ? nullptr : found->second;
  }
  bool has(std::size_t unit) const { return all_.count(unit) != 0; }

  void compile(const std::vector<CompileUnit>& units, const std::set<std::size_t>& wanted,
               EngineOptions engine) {
    if (wanted.empty()) return;
    engine.shard = {};
    engine.progress = nullptr;
    engine.emitted = nullptr;
    const std::vector<std::size_t> places(wanted.begin(), wanted.end());
    std::vector<CompileUnit> chosen;
    chosen.reserve(places.size());
    for (const std::size_t place : places) chosen.push_back(units[place]);
    others_ = run_units(chosen, engine).results;
    for (UnitResult& result : others_) {
      result.unit = places[result.unit];
      all_[result.unit] = &result;
    }
  }

 private:
  std::map<std::size_t, UnitResult*> all_;
  std::vector<UnitResult> others_;
};

}  // namespace

void link_stages(const std::vector<CompileUnit>& units, const EngineOptions& engine,
                 std::vector<UnitResult>& results) {
  Results known(results);
  StagePairs pairs;
  std::vector<std::size_t> before_fragments;
  for (const auto& [number, stages] : programs_of(units))
    for (const Neighbours& two : neighbours(stages)) {
      add_pairs(units, two, pairs);
      if (units[two.after->front()].compile.stage == Stage::fragment)
        before_fragments.insert(before_fragments.end(), two.before->begin(), two.before->end());
    }
  std::erase_if(pairs, [&](const StagePair& pair) { return !known.has(pair.second); });
  std::erase_if(before_fragments, [&](std::size_t unit) { return !known.has(unit); });
  std::set<std::size_t> wanted;
  for (const StagePair& pair : pairs)
    if (!known.has(pair.first)) wanted.insert(pair.first);
  known.compile(units, wanted, engine);
  Linkage linkage(units);
  std::map<std::size_t, std::vector<const UnitResult*>> before;
  for (const StagePair& pair : pairs)
    if (const UnitResult* result = known.of(pair.first)) before[pair.second].push_back(result);
  for (const auto& [after, writers] : before)
    if (UnitResult* result = known.of(after)) linkage.check(writers, *result);
  for (const std::size_t unit : before_fragments)
    if (UnitResult* result = known.of(unit)) linkage.check_position(*result);
}

}  // namespace penumbra::validation
