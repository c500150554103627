// The results of a validation run, record by record, and the report formats.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"

namespace penumbra::validation {

// `absent` means that the target has no such stage, or nothing can emit it; or that the manifest lists the
// technique as absent for the target, and it does fail there. `unreached` means that there was no SPIR-V from
// which the target could be generated; the failure is reported once, under "spirv". `unchecked` means that it
// could not be checked here, for a reason other than the shader (a file that only the Unity editor has).
enum class VariantStatus { passed, failed, absent, unreached, unchecked };

// The target of diagnostics about a file or a pass as a whole: no variant was compiled for it.
inline constexpr const char* whole_source = "source";

// The rule of the note that a variant's module is made from FXC's bytecode, because glslang refuses the text.
inline constexpr const char* from_bytecode = "from-bytecode";
bool is_from_bytecode(const std::vector<hlsl::Diagnostic>& said);

// The rules of errors about a compiler that crashed, which is a failure of this program and not of the
// shader, and about one that reached a limit of time or memory.
inline constexpr const char* compiler_crash = "compiler-crash";
inline constexpr const char* compiler_limit = "compiler-limit";

// The result of one entry point of one file with one keyword set for one target.
struct VariantRecord {
  std::string technique;  // the technique's name; empty for a user's file
  std::string file;
  std::string shader;  // ShaderLab name, "Universal Render Pipeline/Lit"; empty outside ShaderLab
  std::string pass;    // "ForwardLit", or "0.2" (subshader.pass, from 0) where a pass has no name
  std::string entry;
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::string> keywords;
  std::string target;
  VariantStatus status = VariantStatus::passed;
  std::vector<hlsl::Diagnostic> diagnostics;
  std::string reason;        // why it is absent or unchecked
  bool cached = false;       // the result is from an earlier run
  std::string reproduction;  // a file with the text that crashed or hung a compiler; else empty
  std::string module;        // identifies the SPIR-V: records of equal module and target are checked once
  std::size_t place = 0;     // place of the variant in the order of the whole request, including other shards
};

// A minimal set of keywords that is sufficient for one error.
struct MinimalKeywords {
  hlsl::Diagnostic error;
  std::vector<std::string> keywords;  // if empty, every variant has it
};

struct ValidationReport {
  std::vector<VariantRecord> records;  // records in the order of the request, whatever the number of jobs
  std::size_t unique = 0;              // distinct pairs of SPIR-V module and target among them
  double seconds = 0.0;                // of a merged report: the sum over all machines
  std::map<std::string, std::string> checks;  // target -> description of its check
  std::map<std::string, std::string> rules;   // lint rule -> what it finds, in one sentence
  std::vector<MinimalKeywords> minimal;       // minimal keywords of the errors, if they were requested
  unsigned shard = 1;                         // this report is shard `shard` of `shards`, from 1
  unsigned shards = 1;                        // 1: the whole run
  std::string fingerprint;  // hash of the request without its shard: only reports that share it can be merged
  // Folders of packages that are not the user's own: a warning in one is a note, and so is an error of a
  // program in one. Their names are the beginnings of the names of files.
  std::vector<std::string> packages;

  std::size_t count(VariantStatus status) const;
};

const char* status_name(VariantStatus status);  // the name of the enumerator
std::optional<VariantStatus> find_status(std::string_view name);

// `text` is for people. `json` has everything, and is the input of read_report_json(). `sarif` is SARIF
// 2.1.0, for code scanning. `junit` is JUnit XML, for test reports. `github` has workflow commands that
// GitHub shows as annotations.
enum class ReportForm { text, json, sarif, junit, github };

inline constexpr ReportForm all_report_forms[] = {ReportForm::text, ReportForm::json, ReportForm::sarif,
                                                  ReportForm::junit, ReportForm::github};

const char* form_name(ReportForm form);  // the name of the enumerator
std::optional<ReportForm> find_report_form(std::string_view name);

struct ReportStyle {
  bool colour = false;   // text: ANSI colours
  bool verbose = false;  // text, sarif and github: every note, and what the baseline has
  bool werror = false;   // warnings fail
  // The findings of a baseline (finding_keys()), which do not fail; without a value there is no baseline.
  std::optional<std::set<std::string>> known;
  // In sarif, junit and github, files below `root` are named relative to it, and relative names start from
  // `folder`. Both are absolute, or empty: then names are not changed.
  std::filesystem::path root;
  std::filesystem::path folder;
};

// Returns whether the run fails: by an error, or, with `werror`, by a warning, of a file of the user's own
// that the baseline does not have.
bool fails(const ValidationReport& report, const ReportStyle& style);

std::string format_report(const ValidationReport& report, ReportForm form, const ReportStyle& style = {});

std::string report_text(const ValidationReport& report, const ReportStyle& style = {});
std::string report_json(const ValidationReport& report);
std::string report_sarif(const ValidationReport& report, const ReportStyle& style = {});
std::string report_junit(const ValidationReport& report, const ReportStyle& style = {});
std::string report_github(const ValidationReport& report, const ReportStyle& style = {});

// Returns what crashed, and on which file, program, variant and target; empty where nothing did.
std::string crash_text(const ValidationReport& report);

// A count of the variants that only one of the two compilers refuses: FXC, which decides in Unity, or
// glslang, from whose SPIR-V all targets but d3d11 are made.
struct FrontEnds {
  std::size_t compared = 0;       // variants that both compiled or refused
  std::size_t both = 0;           // refused by both
  std::size_t fxc_alone = 0;      // refused by FXC alone
  std::size_t glslang_alone = 0;  // refused by glslang alone: Unity would compile them for Direct3D
};

// Returns zeros where the report has results of one compiler only.
FrontEnds front_ends(const ValidationReport& report);

// Returns one line for a report; empty where nothing was compared.
std::string text_of(const FrontEnds& counts);

}  // namespace penumbra::validation
