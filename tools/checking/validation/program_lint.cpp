#include "validation/program_lint.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "hlsl/source_text.h"
#include "input/mistake.h"
#include "lint/suppression.h"
#include "validation/kept_answers.h"
#include "validation/unit_lint.h"

namespace penumbra::validation {

namespace {

using SubShaderKey = std::tuple<std::string, std::string, int>;             // file, shader, index
using ProgramKey = std::tuple<std::string, std::string, int, std::string>;  // the same and pass
// The results in the order of the run.
using ResultsOfUnits = std::vector<std::pair<const CompileUnit*, const UnitResult*>>;

template <typename Named>
SubShaderKey sub_shader_of(const Named& named) {
  return {named.file, named.shader, named.sub_shader};
}

template <typename Named>
ProgramKey program_of(const Named& named) {
  return {named.file, named.shader, named.sub_shader, named.pass};
}

// Units that differ in neither are compiled for one graphics API.
std::string source_name(const CompileUnit& unit) {
  std::string source = unit.compile.entry + " " + hlsl::stage_name(unit.compile.stage);
  for (const std::string& target : unit.targets) source += " " + target;
  return source;
}

bool is_instanced(const CompileUnit& unit) {
  return std::any_of(unit.keywords.begin(), unit.keywords.end(), [](const std::string& keyword) {
    return keyword == "INSTANCING_ON" || keyword == "PROCEDURAL_INSTANCING_ON" ||
           keyword == "DOTS_INSTANCING_ON";
  });
}

std::vector<hlsl::Diagnostic> keyword_findings(const ProgramToLint& program, const ResultsOfUnits& results) {
  if (!program.is_whole || program.keywords.empty()) return {};
  lint::ProgramKeywords keywords;
  keywords.file = program.file;
  keywords.program = program.pass.empty() ? "this program" : "pass '" + program.pass + "'";
  keywords.declared = program.keywords;
  for (const auto& [unit, result] : results) {
    if (compiled_by_fxc(*unit)) continue;  // the same text has a module from glslang, by which it is compared
    if (result->module_key.empty())
      return {};  // a variant that does not compile may be the one that the keyword changes
    keywords.variants.push_back({unit->keywords, result->module_key, source_name(*unit)});
  }
  return lint::unused_keyword_findings(keywords);
}

// Returns the stages whose buffers are compared: for one graphics API, each layout of each pass and stage
// once.
std::vector<lint::PassStage> stages_of(const ResultsOfUnits& results) {
  std::vector<lint::PassStage> stages;
  std::set<std::tuple<std::string, hlsl::Stage, std::string>> known;
  for (const auto& [unit, result] : results) {
    if (unit->targets != results.front().first->targets || is_instanced(*unit) || !result->buffers) continue;
    if (!known.emplace(unit->pass, unit->compile.stage, *result->buffers).second) continue;
    std::optional<std::vector<lint::ConstantBuffer>> buffers = decode_buffers(*result->buffers);
    if (!buffers) continue;
    stages.push_back({unit->pass, unit->compile.stage, unit->keywords, *std::move(buffers)});
  }
  return stages;
}

bool has_material(const std::vector<lint::PassStage>& stages) {
  return std::any_of(stages.begin(), stages.end(), [](const lint::PassStage& stage) {
    return std::any_of(stage.buffers.begin(), stage.buffers.end(),
                       [](const lint::ConstantBuffer& buffer) { return buffer.name == "UnityPerMaterial"; });
  });
}

std::vector<hlsl::Diagnostic> buffer_findings(const ProgramToLint& program, const ResultsOfUnits& results) {
  lint::ShaderToLint shader{program.file, program.properties, stages_of(results)};
  std::vector<hlsl::Diagnostic> findings = lint::property_type_findings(shader);
  if (program.scriptable_pipeline || has_material(shader.stages))
    for (hlsl::Diagnostic& finding : lint::srp_batcher_findings(shader))
      findings.push_back(std::move(finding));
  return findings;
}

class Findings {
 public:
  void add(const ProgramToLint& program, std::vector<hlsl::Diagnostic> findings) {
    if (findings.empty()) return;
    for (hlsl::Diagnostic& finding : findings) read(finding);
    VariantRecord& record = record_of(program);
    for (hlsl::Diagnostic& finding : wanted(lint::without_suppressed(std::move(findings), sources_), order_))
      record.diagnostics.push_back(std::move(finding));
  }

  std::vector<VariantRecord> take() {
    std::erase_if(records_, [](const VariantRecord& record) { return record.diagnostics.empty(); });
    return std::move(records_);
  }

  explicit Findings(const LintOrder& order) : order_(order) {}

 private:
  void read(hlsl::Diagnostic& diagnostic) {
    if (!sources_.contains(diagnostic.file))
      sources_.add(diagnostic.file, hlsl::read_source(diagnostic.file).text);
    diagnostic.source_line = sources_.line(diagnostic.file, diagnostic.line);
  }

  VariantRecord& record_of(const ProgramToLint& program) {
    for (VariantRecord& record : records_)
      if (record.file == program.file && record.shader == program.shader && record.pass == program.pass)
        return record;
    VariantRecord record;
    record.file = program.file;
    record.shader = program.shader;
    record.pass = program.pass;
    record.target = whole_source;
    return records_.emplace_back(std::move(record));
  }

  const LintOrder& order_;
  hlsl::SourceFiles sources_;
  std::vector<VariantRecord> records_;
};

}  // namespace

std::vector<VariantRecord> program_findings(const std::vector<ProgramToLint>& programs,
                                            const std::vector<CompileUnit>& units,
                                            const std::vector<UnitResult>& results, const LintOrder& order) {
  std::map<ProgramKey, ResultsOfUnits> of_program;
  std::map<SubShaderKey, ResultsOfUnits> of_sub_shader;
  for (const UnitResult& result : results) {
    const CompileUnit& unit = units[result.unit];
    of_program[program_of(unit)].emplace_back(&unit, &result);
    of_sub_shader[sub_shader_of(unit)].emplace_back(&unit, &result);
  }
  Findings findings(order);
  std::set<SubShaderKey> compared;
  const auto lint = [&](const ProgramToLint& program) {
    if (const auto found = of_program.find(program_of(program)); found != of_program.end())
      findings.add(program, keyword_findings(program, found->second));
    const auto found = of_sub_shader.find(sub_shader_of(program));
    if (found != of_sub_shader.end() && compared.insert(found->first).second)
      findings.add(program, buffer_findings(program, found->second));
  };
  for (const ProgramToLint& program : programs)
    with_place(program.file + (program.pass.empty() ? "" : ", pass " + program.pass), [&] { lint(program); });
  return findings.take();
}

}  // namespace penumbra::validation
