#include "validation/answer_unit.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "fxc/messages.h"
#include "input/input_error.h"
#include "lint/interpolated_cascade.h"
#include "lint/text_rules.h"
#include "shaders/bytecode_module.h"
#include "shaders/fxc_program.h"
#include "shaders/source_memory.h"
#include "validation/checked_declarations.h"
#include "validation/kept_answers.h"
#include "validation/source_record.h"
#include "validation/spirv_target.h"
#include "validation/target_check.h"
#include "validation/unit_lint.h"
#include "validation/unit_message.h"

namespace penumbra::validation {

struct UnitService::Memory {
  shaders::SourceMemory sources;
  CheckedDeclarations declarations;
  LintedModules linted;
  std::unique_ptr<fxc::Judge> fxc;
};

namespace {

struct SourceState {
  std::string name;
  std::string hash;
  bool read_by_lint = false;  // the file silences a lint rule somewhere, or a rule reads its conditions
};

bool quotes(const std::vector<hlsl::Diagnostic>& messages, const std::string& file) {
  return std::any_of(messages.begin(), messages.end(),
                     [&](const hlsl::Diagnostic& said) { return said.line > 0 && said.file == file; });
}

bool quotes(const CompileAnswer& answer, const std::string& file) {
  return quotes(answer.diagnostics, file) ||
         std::any_of(answer.of_targets.begin(), answer.of_targets.end(),
                     [&](const shaders::TargetDiagnostics& of) { return quotes(of.diagnostics, file); });
}

class UnitAtWork {
 public:
  UnitAtWork(const UnitJob& job, platform::WorkerLink& link, shaders::SourceMemory& sources,
             CheckedDeclarations& declarations, LintedModules& linted, std::unique_ptr<fxc::Judge>& fxc)
      : job_(job),
        link_(link),
        memory_(sources),
        declarations_(declarations),
        linted_(linted),
        fxc_(fxc),
        cache_(job.context.cache) {}

  UnitReply answer() {
    link_.note(note_text);
    make_text();
    reply_.damaged = cache_.damaged();
    return std::move(reply_);
  }

 private:
  void make_text() {
    try {
      source_ = shaders::expand(job_.unit.compile, memory_);
    } catch (const InputError& error) {  // the file existed when the run began
      reply_.compile = CompileAnswer{};
      reply_.compile->diagnostics.push_back(
          {job_.unit.compile.file.string(), 0, 0, hlsl::Severity::error, error.what(), {}});
      return;
    }
    link_.note(note_compile);
    reply_.dependencies = source_.dependencies;
    if (job_.text_only) {
      shaders::prepare(job_.unit.compile, source_);
      reply_.text = std::move(source_.text);
      reply_.compile = CompileAnswer{};
      reply_.compile->diagnostics = std::move(source_.diagnostics);
    } else if (hlsl::has_errors(source_.diagnostics)) {
      reply_.compile = CompileAnswer{};
      reply_.compile->diagnostics = std::move(source_.diagnostics);
      if (!source_.missing_editor_include.empty())
        reply_.compile->unchecked =
            "'" + source_.missing_editor_include +
            "' ships only with the Unity editor; name its CGIncludes folder with --cginc-root DIR";
    } else {
      answer_text();
    }
  }

  void answer_text() {
    reply_.text_key = text_key(job_.context, job_.unit, source_);
    if (!source_.found_by_case)  // otherwise the record of files is incomplete
      keep(EntryKind::sources, sources_key(job_.context, job_.unit),
           encode(source_record(source_, reply_.text_key)));
    if (!is_mine(question_text, shared_key(job_.unit, reply_.text_key))) return;
    reply_.compile = kept_compile_answer(cache_, reply_.text_key,
                                         [this](const std::string& file) { return hash_as_read(file); });
    reply_.compile_cached = reply_.compile.has_value();
    if (!reply_.compile && compiled_by_fxc(job_.unit)) compile_by_fxc();
    if (!reply_.compile) compile();
    if (!reply_.compile->module_key.empty() && emits(job_.unit)) answer_module();
  }

  // FXC judges the expanded text, before the steps that rewrite it for glslang.
  fxc::Verdict ask_fxc(const std::string& expanded) {
    if (!fxc_) fxc_ = std::make_unique<fxc::Judge>(fxc::require_fxc());
    return fxc_->compile(shaders::fxc_program(job_.unit.compile, expanded));
  }

  // Returns what was said while the text was expanded, and FXC's messages.
  std::vector<hlsl::Diagnostic> messages_of(const fxc::Verdict& verdict,
                                            const shaders::PreprocessedSource& expanded) const {
    const std::string file = job_.unit.compile.file.string();
    std::vector<hlsl::Diagnostic> messages = expanded.diagnostics;
    for (hlsl::Diagnostic& said :
         fxc::diagnostics_of(verdict.messages, expanded.text, file, expanded.sources))
      messages.push_back(std::move(said));
    if (!verdict.compiled && !hlsl::has_errors(messages))
      messages.push_back({file, 0, 0, hlsl::Severity::error, "FXC refuses it without a message", {}});
    return messages;
  }

  void compile_by_fxc() {
    CompileAnswer answer;
    answer.diagnostics = messages_of(ask_fxc(source_.text), source_);
    for (const std::string& file : source_.sources.names())
      if (quotes(answer, file)) answer.quoted.emplace_back(file, source_hash(source_.sources.text(file)));
    keep(EntryKind::compile, reply_.text_key, encode(answer));
    reply_.compile = std::move(answer);
  }

  // FXC decides on a text that glslang refuses. Where FXC refuses the text, too, its messages take the place
  // of glslang's, because they are Unity's; where it accepts the text, its bytecode gives the module. Without
  // a verdict, after a crash of FXC or of what translates its bytecode, glslang's refusal may be of HLSL that
  // it does not know. The text is expanded again, because few are refused.
  void decide_by_fxc(CompileAnswer& answer) {
    const std::vector<hlsl::Diagnostic> of_glslang = answer.diagnostics;
    hlsl::Diagnostic note = *hlsl::first_error(of_glslang);
    const std::string refusal = "glslang refuses it (" + note.message + "), and ";
    if (is_given_up(fxc_target)) {
      answer.unchecked = refusal + "FXC gave no verdict: it crashed or reached a limit";
      std::erase_if(answer.diagnostics,
                    [](const hlsl::Diagnostic& said) { return said.severity == hlsl::Severity::error; });
      return;
    }
    const shaders::PreprocessedSource plain = shaders::expand(job_.unit.compile, memory_);
    const fxc::Verdict verdict = ask_fxc(plain.text);
    answer.diagnostics = messages_of(verdict, plain);
    if (!verdict.compiled) {
      // FXC reports some errors of whole programs without a line.
      if (hlsl::first_error(answer.diagnostics)->line == 0 && note.line > 0) answer.diagnostics = of_glslang;
      return;
    }
    try {
      shaders::BytecodeModule made = shaders::bytecode_module(verdict.bytecode, job_.unit.compile.entry);
      spirv_ = std::move(made.spirv);
      answer.signature = std::make_shared<const std::string>(encode(made.signature));
    } catch (const std::invalid_argument& error) {
      answer.unchecked = "FXC accepts it, but no other target could be made: " + refusal + error.what();
    }
    note.severity = hlsl::Severity::note;
    note.rule = from_bytecode;
    note.message = "FXC accepts this, and glslang does not: " + note.message;
    answer.diagnostics.push_back(std::move(note));
  }

  void answer_module() {
    const std::string key = emitted_key(job_.context, job_.unit, reply_.compile->module_key);
    if (!is_mine(question_module, key)) return;
    reply_.emitted = kept_emitted_answer(cache_, key);
    reply_.emitted_cached = reply_.emitted.has_value();
    if (reply_.emitted) return;
    if (spirv_.empty()) compile();
    emit();
    if (job_.given_up.empty()) keep(EntryKind::emitted, key, encode(*reply_.emitted));
  }

  void compile() {
    std::vector<SourceState> files;
    for (const std::string& file : source_.sources.names()) {
      const std::string& text = source_.sources.text(file);
      files.push_back(
          {file, source_hash(text),
           job_.unit.lint.wanted && (holds_suppression(text) || lint::compares_unity_version(text))});
    }
    std::vector<hlsl::Diagnostic> names;
    if (job_.unit.lint.wanted)
      names = lint::text_findings(source_.text, job_.unit.compile.file.string(), source_.sources);
    shaders::CompileRequest request = job_.unit.compile;
    request.keep_unoptimised = job_.unit.lint.wanted;
    shaders::CompileResult result = by_glslang(request);
    spirv_ = std::move(result.spirv);
    CompileAnswer answer;
    answer.diagnostics = std::move(result.diagnostics);
    answer.of_targets = std::move(result.of_targets);
    if (!spirv_.empty()) answer.signature = std::make_shared<const std::string>(encode(result.signature));
    const bool decided = fxc_decides(job_.context, job_.unit) && hlsl::has_errors(answer.diagnostics);
    if (decided) {
      link_.note(fxc_target);
      decide_by_fxc(answer);
      link_.note(note_compile);
    }
    if (!spirv_.empty()) answer.module_key = module_key(spirv_);
    if (job_.wants_emitted && !spirv_.empty()) add_spirv();
    if (!result.unoptimised.empty() && !is_given_up(note_lint)) lint(result, std::move(names), answer);
    for (SourceState& file : files)
      if (file.read_by_lint || quotes(answer, file.name))
        answer.quoted.emplace_back(std::move(file.name), std::move(file.hash));
    const bool crash_decided = decided && job_.given_up.size() == 1 && is_given_up(note_compile);
    if (job_.given_up.empty() || crash_decided) keep(EntryKind::compile, reply_.text_key, encode(answer));
    reply_.compile = std::move(answer);
    reply_.compile_cached = false;
  }

  void add_spirv() {
    const std::string_view bytes(reinterpret_cast<const char*>(spirv_.data()),
                                 spirv_.size() * sizeof spirv_[0]);
    for (const std::string& target : job_.unit.targets)
      if (is_spirv_target(target)) reply_.emitted_texts.emplace_back(target, bytes);
  }

  shaders::CompileResult by_glslang(const shaders::CompileRequest& request) {
    if (is_given_up(note_compile)) {
      shaders::CompileResult crashed;
      crashed.diagnostics = {{request.file.string(), 0, 0, hlsl::Severity::error, "it crashes", {}}};
      return crashed;
    }
    return job_.sharing == Sharing::nothing
               ? compile_whole(request, std::move(source_))
               : declarations_.compile(request, std::move(source_), job_.sharing);
  }

  void lint(const shaders::CompileResult& result, std::vector<hlsl::Diagnostic> names,
            CompileAnswer& answer) {
    link_.note(note_lint);
    for (hlsl::Diagnostic& message : linted_.messages(job_.unit, result, std::move(names)))
      answer.diagnostics.push_back(std::move(message));
    answer.buffers = std::make_shared<const std::string>(encode(lint::constant_buffers(result.unoptimised)));
    if (job_.unit.compile.stage == hlsl::Stage::vertex && !spirv_.empty()) {
      shaders::Signature signature = result.signature;
      const std::set<std::uint32_t> of_cascade = lint::outputs_of_cascade(spirv_);
      for (shaders::SignatureElement& element : signature)
        element.of_cascade =
            element.output && of_cascade.contains(static_cast<std::uint32_t>(element.location));
      answer.signature = std::make_shared<const std::string>(encode(signature));
    }
    link_.note(note_compile);
  }

  bool is_given_up(std::string_view target) const {
    return std::find(job_.given_up.begin(), job_.given_up.end(), target) != job_.given_up.end();
  }

  void emit() {
    reply_.emitted.emplace();
    shaders::CrossCompiler module(std::move(spirv_));
    for (const std::string& target : job_.unit.targets) {
      if (is_compiled_target(target)) continue;
      std::vector<hlsl::Diagnostic>& said = reply_.emitted->emplace_back();
      if (is_given_up(target)) continue;
      link_.note(target);
      const auto driver = job_.context.drivers.find(target);
      const bool checked = driver != job_.context.drivers.end() && !driver->second.empty();
      shaders::CrossCompileResult result = check_target(module, job_.unit.compile.stage, target, checked);
      said = std::move(result.diagnostics);
      if (job_.wants_emitted && !result.text.empty())
        reply_.emitted_texts.emplace_back(target, std::move(result.text));
      if (is_from_bytecode(reply_.compile->diagnostics)) leave_unchecked(said);
    }
  }

  // Unity makes a target's text from the bytecode by a translator of its own: an error in what vkd3d and
  // SPIRV-Cross make of it is not one of the shader.
  static void leave_unchecked(std::vector<hlsl::Diagnostic>& said) {
    const hlsl::Diagnostic* error = hlsl::first_error(said);
    if (error == nullptr) return;
    hlsl::Diagnostic first = *error;
    first.severity = hlsl::Severity::note;
    first.rule = from_bytecode;
    first.message = "what is made from FXC's bytecode could not be checked: " + first.message;
    said = {std::move(first)};
  }

  void keep(EntryKind kind, std::string key, std::string content) {
    if (!job_.context.cache.empty()) reply_.to_keep.push_back({kind, std::move(key), std::move(content)});
  }

  bool is_mine(char kind, const std::string& key) { return link_.ask(kind + key) == answer_mine; }

  std::optional<std::string> hash_as_read(const std::string& file) const {
    if (!source_.sources.contains(file)) return std::nullopt;
    return source_hash(source_.sources.text(file));
  }

  const UnitJob& job_;
  platform::WorkerLink& link_;
  shaders::SourceMemory& memory_;
  CheckedDeclarations& declarations_;
  LintedModules& linted_;
  std::unique_ptr<fxc::Judge>& fxc_;
  platform::CacheStore cache_;
  shaders::PreprocessedSource source_;
  std::vector<std::uint32_t> spirv_;
  UnitReply reply_;
};

}  // namespace

UnitService::UnitService() = default;
UnitService::~UnitService() = default;

std::string UnitService::answer(const std::string& job, platform::WorkerLink& link) {
  const std::optional<UnitJob> decoded = decode_job(job);
  if (!decoded) throw std::logic_error("malformed job");
  std::unique_ptr<Memory> memory;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!free_.empty()) {
      memory = std::move(free_.back());
      free_.pop_back();
    }
  }
  if (!memory) memory = std::make_unique<Memory>();
  const UnitReply reply =
      UnitAtWork(*decoded, link, memory->sources, memory->declarations, memory->linted, memory->fxc).answer();
  const std::lock_guard<std::mutex> lock(mutex_);
  free_.push_back(std::move(memory));
  return encode(reply);
}

void UnitService::start_fxc(const fxc::JudgeLimits& limits) {
  auto memory = std::make_unique<Memory>();
  memory->fxc = std::make_unique<fxc::Judge>(fxc::require_fxc(), limits);
  const std::lock_guard<std::mutex> lock(mutex_);
  free_.push_back(std::move(memory));
}

}  // namespace penumbra::validation
