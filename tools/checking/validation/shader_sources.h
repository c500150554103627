// The programs in shader files: the programs of a .shader, the kernels of a .compute, the entry point of an
// .hlsl, each with its variants, which are counted before anything is compiled.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "project/include_search.h"
#include "project/shader_files.h"
#include "validation/platform_targets.h"
#include "validation/program_lint.h"
#include "validation/report.h"
#include "validation/unit.h"
#include "variants/build_settings.h"
#include "variants/keyword_space.h"
#include "variants/plan.h"
#include "variants/platform_defines.h"
#include "variants/pragmas.h"
#include "variants/used_variants.h"

namespace penumbra::validation {

struct SourceOptions {
  std::vector<PlatformTargets> platforms;
  variants::Narrowing narrowing;
  std::optional<variants::UsedVariants> used;  // narrows the variants of .shader files further
  variants::BuildSettings build_settings;      // the project's
  project::IncludeRoots roots;
  std::vector<std::pair<std::string, std::string>> defines;  // defined for every variant
  // The entry points that the user gives for .hlsl files. Keyword pragmas of the file apply.
  std::vector<std::pair<std::string, hlsl::Stage>> entries;
  // The largest number of variants per entry point, spaced evenly; 0 means all.
  std::uint64_t sample = 0;
  std::vector<variants::Keywords> keyword_sets;  // for .hlsl files, in place of those of their pragmas
  LintOrder lint;                                // the shader target is each variant's own
};

// One program of a file for one platform.
struct SourceProgram {
  int number = 0;  // its place among the programs
  int source = 0;  // equal for one program of a file on all graphics APIs, which stand together
  std::string file;
  std::string shader;  // see VariantRecord
  std::string pass;
  int sub_shader = 0;
  int line = 0;  // line of HLSLPROGRAM; 0 where the file is one program
  int column = 0;
  bool is_pass = false;              // a pass of a .shader, which must have a vertex and a fragment stage
  bool scriptable_pipeline = false;  // as in ProgramToLint
  bool outside_unity = false;        // an .hlsl file that is in no Unity project
  std::vector<lint::MaterialProperty> properties;  // as in ProgramToLint
  variants::Narrowing narrowing;
  hlsl::SharedText text;   // lines and columns are the file's own
  std::string light_mode;  // as in variants::Platform, and the next
  bool includes_hlsl_support = false;
  std::vector<std::string> targets;
  variants::Platform platform;
  shaders::VulkanVersion vulkan = shaders::VulkanVersion::v1_1;
  variants::Pragmas pragmas;
  std::vector<std::pair<std::string, hlsl::Stage>> entries;
  std::vector<variants::Kernel> kernels;
  std::vector<variants::Keywords> keyword_sets;  // if not empty, these replace the space
  std::shared_ptr<const variants::KeywordSpace> space;
  // The same program stands before for the same graphics API: FXC's, or that of another Vulkan version. Its
  // variants are Unity's same variants, and are counted once.
  bool counted_before = false;
};

class ShaderSources {
 public:
  explicit ShaderSources(SourceOptions options) : options_(std::move(options)) {}

  // A file that cannot be read throws InputError; errors in it become failed or unchecked records.
  void add(const project::ShaderFile& file);

  const std::vector<SourceProgram>& programs() const { return programs_; }
  // Returns the files, programs and passes that are not compiled, and why: a syntax error, a surface shader,
  // GLSL.
  const std::vector<VariantRecord>& records() const { return records_; }
  // Returns whether programs() declare every keyword of the files: false if a file or its pragmas could not
  // be parsed.
  bool knows_keywords() const { return knows_keywords_; }

  std::size_t program_count() const;  // each program once, whatever the graphics APIs
  // Returns the programs of plan(): those of one graphics API once.
  std::vector<const SourceProgram*> counted() const;
  variants::Plan plan() const;
  // Returns a plan for the same programs, with these clauses beside the narrowing.
  variants::Plan plan(const std::vector<variants::Clause>& more) const;
  std::string refusal(std::uint64_t limit) const;  // empty while the count is within the limit
  std::vector<CompileUnit> units() const;
  // Returns the unit of the entry point at `index` of one of programs(): its entries come first, then its
  // kernels.
  CompileUnit entry_unit(const SourceProgram& program, std::size_t index,
                         const variants::Keywords& keywords) const;
  std::vector<ProgramToLint> to_lint() const;  // each program once, whatever the graphics APIs

 private:
  SourceProgram program_of(const project::ShaderFile& file) const;  // with what holds for all of the file
  void add_shader(const project::ShaderFile& file, const std::string& text);
  void add_compute(const project::ShaderFile& file, const std::string& text);
  void add_hlsl(const project::ShaderFile& file, const std::string& text);
  void add_program(const SourceProgram& program);
  void say(const std::string& file, const std::string& shader, const std::string& pass,
           std::vector<hlsl::Diagnostic> diagnostics);
  void leave_unchecked(const SourceProgram& program, const std::string& reason);
  using Spaces = std::vector<std::shared_ptr<const variants::KeywordSpace>>;
  Spaces spaces() const;  // the spaces of counted()
  std::vector<variants::PlannedProgram> planned(const Spaces& spaces) const;
  CompileUnit unit(const SourceProgram& program, const std::string& entry, hlsl::Stage stage,
                   const variants::Keywords& keywords) const;

  SourceOptions options_;
  std::vector<SourceProgram> programs_;
  std::vector<VariantRecord> records_;
  bool knows_keywords_ = true;
};

}  // namespace penumbra::validation
