#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "lint/assignment_flow.h"
#include "lint/stage_rules.h"

namespace penumbra::lint {

namespace {

constexpr std::size_t most_listed = 4;

// Turns "Fill(f1;f1;" into "Fill"; glslang puts '@' before the shader's own entry function.
std::string plain_name(const std::string& name) {
  const std::string cut = name.substr(0, name.find('('));
  return !cut.empty() && cut.front() == '@' ? cut.substr(1) : cut;
}

bool is_entry(const LintedCode& linted, const spirv::Function& function) {
  return linted.code.name(function.id).rfind('@', 0) == 0;
}

// Returns "'o.uv', 'o.fog.x' and 3 more"; for an empty `base` only the members.
std::string missing(ComponentLayout& layout, const std::string& base, spirv::Id type, Components set) {
  std::string list;
  std::size_t listed = 0;
  while (!all(set) && listed < most_listed) {
    const ComponentLayout::Missing part = layout.first_missing(type, set);
    const std::string shown = base.empty() && !part.path.empty() ? part.path.substr(1) : base + part.path;
    list += (list.empty() ? "'" : ", '") + shown + "'";
    ++listed;
    for (std::size_t i = 0; i < part.count; ++i) set[part.first + i] = true;
  }
  return all(set) ? list : list + " and more";
}

std::vector<std::string> words_of(const std::string& name, const std::string& path) {
  std::vector<std::string> words;
  const std::size_t dot = path.rfind('.');
  if (dot != std::string::npos) words.push_back(path.substr(dot + 1));
  words.push_back(name);
  return words;
}

// "inout TriangleStream<V> stream" is an output stream of a geometry shader, not a value; in SPIR-V it is an
// output parameter like any other, so the source declaration is used.
bool declares_stream(const std::string& line, const std::string& parameter) {
  for (std::size_t at = line.find("Stream<"); at != std::string::npos; at = line.find("Stream<", at + 1)) {
    const std::size_t name = line.find_first_not_of(" >", std::min(line.find('>', at), line.size()));
    if (name != std::string::npos && line.compare(name, parameter.size(), parameter) == 0) return true;
  }
  return false;
}

hlsl::Diagnostic output_finding(const LintedCode& linted, ComponentLayout& layout,
                                const spirv::Function& function, const UnsetOutput& output) {
  const std::string name = plain_name(linted.code.name(function.id));
  if (output.nothing_returned)
    return finding_at_function(linted, "output-not-set", output.place, name, "",
                               "not every path through '" + name + "' returns a value");
  if (output.parameter != 0) {
    const std::string parameter = linted.code.name(output.parameter);
    hlsl::Diagnostic finding =
        finding_at_function(linted, "output-not-set", output.place, name, parameter,
                            "out parameter " + missing(layout, parameter, output.type, output.set) + " of '" +
                                name + "' is not set on every path");
    // Direct3D rejects values that are never assigned, and warns about those assigned on some paths only.
    if (output.ever_set) finding.severity = hlsl::Severity::warning;
    return finding;
  }
  const std::string parts = missing(layout, "", output.type, output.set);
  const std::string what =
      parts == "''" ? "what '" + name + "' returns" : "output " + parts + " of '" + name + "'";
  hlsl::Diagnostic finding =
      finding_at(linted, "output-not-set", output.place, {"return"}, what + " is not set on every path");
  finding.severity = hlsl::Severity::warning;
  return finding;
}

hlsl::Diagnostic read_finding(const LintedCode& linted, ComponentLayout& layout, const UnsetRead& read) {
  const std::string callee = read.callee == 0 ? "" : plain_name(linted.code.name(read.callee));
  const std::string path = layout.first_missing(read.type, read.known).path;
  if (read.variable == 0)
    return finding_at(linted, "read-before-set", read.place, words_of(callee, path),
                      "'" + path.substr(path.empty() ? 0 : 1) + "' of what '" + callee +
                          "' returns is read, but not set on every path");
  const std::string name = linted.code.name(read.variable);
  const std::string where = callee.empty() ? " is read" : " is passed to '" + callee + "', which reads it,";
  const std::string why = read.ever_set ? " before it is set on every path" : " but never set";
  return finding_at(linted, "read-before-set", read.place, words_of(name, path),
                    missing(layout, name, read.type, read.known) + where + why);
}

}  // namespace

std::vector<hlsl::Diagnostic> unset_values(const LintedCode& linted) {
  ComponentLayout layout(linted.code);
  std::vector<hlsl::Diagnostic> findings;
  std::map<spirv::Id, AssignmentFindings> by_function = assignment_findings(linted.code);
  for (const spirv::Function& function : linted.code.functions()) {
    const AssignmentFindings& found = by_function[function.id];
    for (const UnsetOutput& output : found.outputs) {
      // Components that a helper function leaves unassigned in a returned struct are reported where they are
      // read, or where they leave the stage.
      const bool part_of_result = output.parameter == 0 && !output.nothing_returned;
      if (part_of_result && !is_entry(linted, function)) continue;
      hlsl::Diagnostic finding = output_finding(linted, layout, function, output);
      const bool is_stream =
          output.parameter != 0 && declares_stream(finding.source_line, linted.code.name(output.parameter));
      if (!is_stream) findings.push_back(std::move(finding));
    }
    std::set<std::tuple<spirv::Id, spirv::Id, std::string>>
        told;  // a variable is reported where it is first read
    for (const UnsetRead& read : found.reads)
      if (told.insert({read.variable, read.variable == 0 ? read.callee : 0,
                       layout.first_missing(read.type, read.known).path})
              .second)
        findings.push_back(read_finding(linted, layout, read));
    if (found.too_large)
      findings.push_back(finding_at_function(linted, "not-checked", function.place,
                                             plain_name(linted.code.name(function.id)), "",
                                             "'" + plain_name(linted.code.name(function.id)) +
                                                 "' is too large for data-flow analysis of its variables"));
  }
  return findings;
}

}  // namespace penumbra::lint
