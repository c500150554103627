#include "validation/reproduction.h"

#include <algorithm>
#include <system_error>

#include "hlsl/source_text.h"
#include "input/file_name.h"
#include "input/input_error.h"
#include "input/text_line.h"
#include "platform/atomic_file.h"
#include "platform/content_hash.h"
#include "validation/kept_answers.h"
#include "validation/unit_message.h"

namespace penumbra::validation {

namespace {

namespace fs = std::filesystem;

// A name must neither end the comment nor extend it, as a backslash at the end of a line does.
std::string in_comment(const std::string& text) {
  std::string line = in_one_line(text);
  std::replace(line.begin(), line.end(), '\\', ' ');
  return line;
}

std::string source_text(const CompileUnit& unit) {
  if (unit.compile.text) return *unit.compile.text;
  return hlsl::read_source(unit.compile.file).text;
}

std::string name_of(const CompileUnit& unit, const std::string& content) {
  const std::string stem =
      file_name_part(unit.technique.empty() ? fs::path(unit.file).stem().string() : unit.technique, 100);
  return stem + "-" + platform::ContentHash().update(content).hex().substr(0, 16) + ".hlsl";
}

// Returns the value of --target with which the crash occurs again.
std::string target_of(const CompileUnit& unit, const Crash& crash) {
  return compiled_by_fxc(unit) ? unit.targets.front() : crash.target;
}

std::string head(const CompileUnit& unit, const Crash& crash, const std::string& file_name) {
  const std::string stage = hlsl::stage_name(unit.compile.stage);
  const bool by_lint = crash.target == note_lint;
  std::string text = (by_lint ? "// lint " : "// " + target_of(unit, crash) + ": the compiler ") +
                     crash.failure + ".\n// Of " + in_comment(unit.file);
  if (!unit.shader.empty()) text += ", shader " + in_comment(unit.shader) + ", pass " + in_comment(unit.pass);
  text += "; entry " + in_comment(unit.compile.entry) + ", stage " + stage + "\n// Defines:";
  for (const auto& [name, value] : unit.compile.defines)
    text.append(in_comment(std::string(" ").append(name).append("=").append(value)));
  if (crash.text.empty()) text += "\n// The source as it is: the preprocessor does not finish.";
  return text + "\n// See it: penumbra validate " + file_name + " --entry " + in_comment(unit.compile.entry) +
         " --stage " + stage + " --target " + (by_lint ? std::string(note_compile) : target_of(unit, crash)) +
         "\n";
}

}  // namespace

std::string write_reproduction(const fs::path& folder, const CompileUnit& unit, const Crash& crash) {
  if (folder.empty()) return {};
  const std::string text = crash.text.empty() ? source_text(unit) : crash.text;
  const std::string name = name_of(unit, text + crash.target);
  std::error_code error;
  fs::create_directories(folder, error);
  try {
    platform::write_file_atomically(folder / name, head(unit, crash, name) + text);
  } catch (const InputError&) {
    return {};
  }
  return (folder / name).string();
}

}  // namespace penumbra::validation
