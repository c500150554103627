#include "validation/engine.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "hlsl/source_text.h"
#include "input/input_error.h"
#include "platform/build_identity.h"
#include "platform/cache_store.h"
#include "platform/interrupt.h"
#include "platform/terminal.h"
#include "shaders/compile_message.h"
#include "validation/answer_unit.h"
#include "validation/kept_answers.h"
#include "validation/reproduction.h"
#include "validation/source_record.h"
#include "validation/spirv_target.h"
#include "validation/target_check.h"
#include "validation/unit_message.h"
#include "validation/waiting_units.h"

namespace penumbra::validation {
namespace {

// The state of a run: the units that wait, those whose results are known, and the unit whose answer others
// share.
class UnitRun final : public platform::WorkSource {
 public:
  // Units and options must outlive the run. Throws EnvironmentError when a target's driver is not there.
  UnitRun(const std::vector<CompileUnit>& units, const EngineOptions& options);

  void recall();  // takes results from the cache
  void work();    // computes the rest
  EngineRun take() const;
  std::uint64_t written() const { return cache_.bytes_written(); }

  std::optional<platform::WorkerMessage> next(unsigned worker) override;
  std::string answer_question(std::size_t place, const std::string& question) override;
  void finished(std::size_t place, platform::WorkerOutcome outcome) override;

 private:
  struct Failure {
    std::string message;
    std::string reproduction;
    bool limited = false;  // by a limit of time or memory
  };
  // The state of one unit so far.
  struct State {
    UnitReply reply;
    std::map<std::string, Failure> failures;  // failures by target: crashes, hangs, memory
    std::optional<Crash> reproducing;         // set while the text of this unit is being made
    bool sent_again = false;                  // true after a worker was ended from outside
  };

  const CompileUnit& unit(std::size_t place) const { return units_[own_[place]]; }
  void send_first(std::size_t place) { waiting_.put_first(place); }
  void say_done();
  void tell_emitted(const CompileUnit& unit,
                    const std::vector<std::pair<std::string, std::string>>& texts) const;
  void keep(UnitReply& reply);
  void share_texts(UnitReply& reply);
  void crashed(std::size_t place, const platform::WorkerOutcome& outcome);
  void reproduced(std::size_t place, const platform::WorkerOutcome& outcome);
  const std::filesystem::path& keep_folder();
  const State& with_text_of(std::size_t place) const;
  const State& with_module_of(const CompileUnit& unit, const State& compiled) const;
  // Keys of the texts and modules whose results are not of an earlier run.
  struct ComputedNow {
    std::set<std::string> texts;
    std::set<std::string> modules;
  };
  ComputedNow computed_now() const;
  UnitResult result_of(std::size_t place, const ComputedNow& now) const;
  void add_compile_answer(const CompileUnit& unit, const State& compiled, UnitResult& result) const;
  void add_emitted_answers(const CompileUnit& unit, const State& compiled, const State& emitted,
                           UnitResult& result) const;
  static void add_failure(const CompileUnit& unit, const State& state, std::string_view target,
                          TargetResult& result);

  const std::vector<CompileUnit>& units_;
  const EngineOptions& options_;
  std::filesystem::path keep_folder_;  // empty until a file is to be kept
  AnswerContext context_;
  std::vector<std::size_t> own_;  // the shard's; a place is an index of this
  std::vector<State> states_;
  WaitingUnits waiting_;
  std::map<std::string, std::size_t> texts_;    // shared_key() -> the place whose answer it is
  std::map<std::string, std::size_t> modules_;  // emitted key -> the place whose answer it is
  std::map<std::string, std::shared_ptr<const std::string>> shared_texts_;
  std::size_t done_ = 0;
  std::size_t damaged_ = 0;
  platform::CacheStore cache_;
};

// Looks up cached results of earlier runs whose files are unchanged.
class Recall {
 public:
  explicit Recall(const AnswerContext& context) : context_(context), cache_(context.cache) {}

  // Returns a worker's complete reply, without preprocessing the text, or nothing if any part of it is not
  // cached. Throws InputError if the unit's own file cannot be read.
  std::optional<UnitReply> reply_to(const CompileUnit& unit);

  std::size_t damaged() const { return cache_.damaged(); }

 private:
  const AnswerContext& context_;
  platform::CacheStore cache_;
  FilesNow files_;
};

std::optional<UnitReply> Recall::reply_to(const CompileUnit& unit) {
  const std::string main = unit.compile.file.string();
  if (!unit.compile.text && !files_.hash(main))
    throw InputError(main, "cannot be read: " + hlsl::read_source(main).problem);
  const std::optional<std::string> entry =
      cache_.find(name_of(EntryKind::sources), sources_key(context_, unit));
  const std::optional<SourceRecord> record = entry ? decode_source_record(*entry) : std::nullopt;
  if (!record || !record->is_true(files_)) return std::nullopt;

  UnitReply reply;
  reply.text_key = record->text_key;
  reply.compile = kept_compile_answer(cache_, record->text_key, [&](const std::string& file) {
    if (unit.compile.text && file == main)
      return std::optional(source_hash(hlsl::normalise_source(*unit.compile.text)));
    return files_.hash(file);
  });
  if (!reply.compile) return std::nullopt;
  if (!reply.compile->module_key.empty() && emits(unit)) {
    reply.emitted = kept_emitted_answer(cache_, emitted_key(context_, unit, reply.compile->module_key));
    if (!reply.emitted) return std::nullopt;
  }
  for (const auto& [file, hash] : record->files) reply.dependencies.emplace_back(file);
  reply.compile_cached = reply.emitted_cached = true;
  return reply;
}

namespace fs = std::filesystem;

AnswerContext context_of(const std::vector<CompileUnit>& units, const EngineOptions& options) {
  AnswerContext context;
  context.cache = options.cache;
  context.build = platform::build_identity();
  for (const CompileUnit& unit : units)
    for (const std::string& target : unit.targets)
      if ((options.drivers || target == fxc_target) && context.drivers.count(target) == 0)
        context.drivers[target] = checking_driver(target);
  return context;
}

// Returns the arguments of serve_units(): a worker opens its drivers before it drops the privileges that
// opening them needs.
std::vector<std::string> with_drivers(std::vector<std::string> arguments, const AnswerContext& context) {
  for (const auto& [target, driver] : context.drivers)
    if (!driver.empty()) arguments.push_back(target);
  return arguments;
}

// Returns the index of the target that reports the compilation's diagnostics.
std::size_t reporting_target(const CompileUnit& unit) {
  const auto spirv = std::find_if(unit.targets.begin(), unit.targets.end(), is_compiled_target);
  return spirv == unit.targets.end() ? 0 : static_cast<std::size_t>(spirv - unit.targets.begin());
}

// Returns the errors that have lines of the source, where those in emitted text have none; null without such
// errors.
const std::vector<hlsl::Diagnostic>* errors_in_source(const CompileAnswer& answer,
                                                      const std::string& target) {
  const auto found = std::find_if(answer.of_targets.begin(), answer.of_targets.end(),
                                  [&](const shaders::TargetDiagnostics& of) { return of.target == target; });
  return found == answer.of_targets.end() ? nullptr : &found->diagnostics;
}

UnitRun::UnitRun(const std::vector<CompileUnit>& units, const EngineOptions& options)
    : units_(units),
      options_(options),
      context_(context_of(units, options)),
      own_(units_of_shard(units, options.shard)),
      states_(own_.size()),
      cache_(options.cache) {}

void UnitRun::recall() {
  Recall known(context_);
  for (std::size_t place = 0; place < own_.size(); ++place) {
    platform::throw_if_interrupted();
    std::optional<UnitReply> reply = known.reply_to(unit(place));
    if (!reply) {
      waiting_.add(variant_of(unit(place)), place);
      continue;
    }
    texts_.emplace(shared_key(unit(place), reply->text_key), place);
    if (reply->emitted)
      modules_.emplace(emitted_key(context_, unit(place), reply->compile->module_key), place);
    share_texts(*reply);
    states_[place].reply = *std::move(reply);
    say_done();
  }
  damaged_ += known.damaged();
}

void UnitRun::work() {
  if (waiting_.size() == 0) return;
  const auto jobs =
      static_cast<unsigned>(std::min<std::size_t>(std::max(1U, options_.jobs), waiting_.size()));
  UnitService service;
  if (options_.worker_arguments.empty())
    platform::run_in_threads(
        jobs,
        [&service](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
        *this);
  else
    platform::run_workers({with_drivers(options_.worker_arguments, context_), jobs, options_.limits}, *this);
}

std::optional<platform::WorkerMessage> UnitRun::next(unsigned worker) {
  const std::optional<std::size_t> next = waiting_.next(worker);
  if (!next) return std::nullopt;
  const std::size_t place = *next;
  UnitJob job{unit(place),
              context_,
              {},
              options_.sharing,
              states_[place].reproducing.has_value(),
              options_.emitted != nullptr};
  for (const auto& [target, failure] : states_[place].failures) job.given_up.push_back(target);
  return platform::WorkerMessage{place, encode(job)};
}

std::string UnitRun::answer_question(std::size_t place, const std::string& question) {
  if (options_.sharing != Sharing::everything) return std::string(answer_mine);
  auto& owners = question.front() == question_text ? texts_ : modules_;
  const bool mine = owners.emplace(question.substr(1), place).first->second == place;
  return std::string(mine ? answer_mine : answer_known);
}

void UnitRun::finished(std::size_t place, platform::WorkerOutcome outcome) {
  State& state = states_[place];
  if (state.reproducing) return reproduced(place, outcome);
  std::optional<UnitReply> reply;
  if (outcome.failure.empty()) {
    reply = decode_reply(outcome.answer);
    if (!reply) outcome.failure = "sent a response that cannot be parsed";
  }
  if (!reply) {
    if (outcome.from_outside && !std::exchange(state.sent_again, true)) return send_first(place);
    return crashed(place, outcome);
  }
  damaged_ += reply->damaged;
  keep(*reply);
  share_texts(*reply);
  tell_emitted(unit(place), std::exchange(reply->emitted_texts, {}));
  state.reply = *std::move(reply);
  say_done();
}

// The target becomes part of a file's name: a worker may be in the hands of what it compiles.
void UnitRun::tell_emitted(const CompileUnit& unit,
                           const std::vector<std::pair<std::string, std::string>>& texts) const {
  if (!options_.emitted) return;
  for (const auto& [target, text] : texts)
    if (std::find(unit.targets.begin(), unit.targets.end(), target) != unit.targets.end())
      options_.emitted(unit, target, text);
}

void UnitRun::keep(UnitReply& reply) {
  for (const EntryToKeep& entry : std::exchange(reply.to_keep, {}))
    cache_.store(name_of(entry.kind), entry.key, entry.content);
}

// Buffers and signatures are shared, because variants have few different ones.
void UnitRun::share_texts(UnitReply& reply) {
  if (!reply.compile) return;
  for (std::shared_ptr<const std::string>* text : {&reply.compile->buffers, &reply.compile->signature})
    if (*text) *text = shared_texts_.try_emplace(**text, *text).first->second;
}

void UnitRun::say_done() {
  ++done_;
  if (options_.progress) options_.progress(done_, own_.size());
}

void UnitRun::crashed(std::size_t place, const platform::WorkerOutcome& outcome) {
  const bool has_no_text = outcome.note.empty() || outcome.note == note_text;
  const std::string target = has_no_text ? std::string(note_compile) : outcome.note;
  const shaders::CompilerFailure failure = shaders::compiler_failure(outcome);
  std::string message = failure.problem;
  if (failure.limited) message += "; " + failure.remedy;  // a crash keeps the text that it failed on
  if (target == note_lint) message = "lint " + outcome.failure + " and reports nothing about this variant";
  states_[place].failures[target] = {std::move(message), {}, failure.limited};
  if (has_no_text) {  // A second attempt would end in the same way, and take as long.
    states_[place].failures[target].reproduction =
        write_reproduction(keep_folder(), unit(place), {target, outcome.failure, {}});
    return say_done();
  }
  states_[place].reproducing = Crash{target, outcome.failure, {}};
  send_first(place);
}

// The unit's text exists, or producing it crashes as well. After a crash in one target, the others are still
// checked, and after a crash of glslang FXC is asked.
void UnitRun::reproduced(std::size_t place, const platform::WorkerOutcome& outcome) {
  State& state = states_[place];
  Crash crash = *std::exchange(state.reproducing, std::nullopt);
  if (std::optional<UnitReply> reply = decode_reply(outcome.answer)) {
    crash.text = std::move(reply->text);
    state.reply.dependencies = std::move(reply->dependencies);
  }
  state.failures[crash.target].reproduction = write_reproduction(keep_folder(), unit(place), crash);
  const bool may_ask_fxc =
      fxc_decides(context_, unit(place)) && !state.failures.contains(std::string(fxc_target));
  if (state.failures.contains(std::string(note_compile)) && !may_ask_fxc) return say_done();
  send_first(place);
}

const fs::path& UnitRun::keep_folder() {
  if (!keep_folder_.empty()) return keep_folder_;
  keep_folder_ = options_.keep;
  if (keep_folder_.empty() && !options_.cache.empty()) keep_folder_ = options_.cache / "failures";
  if (keep_folder_.empty()) keep_folder_ = platform::new_private_directory("penumbra-failures");
  return keep_folder_;
}

const UnitRun::State& UnitRun::with_text_of(std::size_t place) const {
  const State& state = states_[place];
  if (state.reply.compile || state.reply.text_key.empty()) return state;
  return states_[texts_.at(shared_key(unit(place), state.reply.text_key))];
}

const UnitRun::State& UnitRun::with_module_of(const CompileUnit& unit, const State& compiled) const {
  if (compiled.reply.emitted || !compiled.reply.compile || !emits(unit)) return compiled;
  return states_[modules_.at(emitted_key(context_, unit, compiled.reply.compile->module_key))];
}

// A result that another worker of this run has just kept was not computed in an earlier run.
UnitRun::ComputedNow UnitRun::computed_now() const {
  ComputedNow now;
  for (std::size_t place = 0; place < own_.size(); ++place) {
    const UnitReply& reply = states_[place].reply;
    if (!reply.compile) continue;
    if (!reply.compile_cached) now.texts.insert(reply.text_key);
    if (reply.emitted && !reply.emitted_cached)
      now.modules.insert(emitted_key(context_, unit(place), reply.compile->module_key));
  }
  return now;
}

UnitResult UnitRun::result_of(std::size_t place, const ComputedNow& now) const {
  const CompileUnit& unit = this->unit(place);
  const State& compiled = with_text_of(place);
  UnitResult result;
  result.unit = own_[place];
  result.targets.resize(unit.targets.size());
  result.text_key = states_[place].reply.text_key;
  result.dependencies = states_[place].reply.dependencies;
  add_compile_answer(unit, compiled, result);
  result.cached = compiled.reply.compile_cached && !now.texts.contains(compiled.reply.text_key);
  if (!result.module_key.empty()) {
    const State& emitted = with_module_of(unit, compiled);
    if (emits(unit))
      result.cached = result.cached && emitted.reply.emitted_cached &&
                      !now.modules.contains(emitted_key(context_, unit, result.module_key));
    add_emitted_answers(unit, compiled, emitted, result);
  }
  for (TargetResult& target : result.targets)
    if (!result.unchecked.empty())
      target.status = VariantStatus::unchecked;
    else if (hlsl::has_errors(target.diagnostics))
      target.status = VariantStatus::failed;
  return result;
}

// One target reports the diagnostics; without a module the others are unreached.
void UnitRun::add_compile_answer(const CompileUnit& unit, const State& compiled, UnitResult& result) const {
  const std::size_t speaker = reporting_target(unit);
  if (compiled.reply.compile) {
    result.targets[speaker].diagnostics = compiled.reply.compile->diagnostics;
    result.module_key = compiled.reply.compile->module_key;
    result.unchecked = compiled.reply.compile->unchecked;
    result.buffers = compiled.reply.compile->buffers;
    result.signature = compiled.reply.compile->signature;
    add_failure(unit, compiled, note_lint, result.targets[speaker]);
  } else {
    add_failure(unit, compiled, note_compile, result.targets[speaker]);
  }
  if (!result.module_key.empty()) return;
  for (std::size_t i = 0; i < result.targets.size(); ++i)
    if (i != speaker) result.targets[i].status = VariantStatus::unreached;
}

void UnitRun::add_emitted_answers(const CompileUnit& unit, const State& compiled, const State& emitted,
                                  UnitResult& result) const {
  std::size_t next = 0;
  for (std::size_t i = 0; i < unit.targets.size(); ++i) {
    if (is_compiled_target(unit.targets[i])) continue;
    std::vector<hlsl::Diagnostic>& diagnostics = result.targets[i].diagnostics;
    if (emitted.reply.emitted) {
      const std::vector<hlsl::Diagnostic>& of_text = emitted.reply.emitted->at(next++);
      const std::vector<hlsl::Diagnostic>* of_source =
          errors_in_source(*compiled.reply.compile, unit.targets[i]);
      const std::vector<hlsl::Diagnostic>& said = of_source == nullptr ? of_text : *of_source;
      diagnostics.insert(diagnostics.end(), said.begin(), said.end());
      if (is_from_bytecode(said)) result.targets[i].status = VariantStatus::unchecked;
      add_failure(unit, emitted, unit.targets[i], result.targets[i]);
    } else {  // the module was compiled once, and a second attempt crashed earlier
      add_failure(unit, emitted, note_compile, result.targets[i]);
    }
  }
}

void UnitRun::add_failure(const CompileUnit& unit, const State& state, std::string_view target,
                          TargetResult& result) {
  const auto failure = state.failures.find(std::string(target));
  if (failure == state.failures.end()) return;
  const bool lint = target == note_lint;  // the compiler reported nothing
  const char* rule = failure->second.limited ? compiler_limit : compiler_crash;
  result.diagnostics.push_back({unit.file,
                                0,
                                0,
                                lint ? hlsl::Severity::warning : hlsl::Severity::error,
                                failure->second.message,
                                {},
                                lint ? "not-checked" : rule});
  result.reproduction = failure->second.reproduction;
}

EngineRun UnitRun::take() const {
  EngineRun run;
  std::set<std::string> texts;
  std::set<std::string> modules;
  const ComputedNow now = computed_now();
  for (std::size_t place = 0; place < own_.size(); ++place) {
    const UnitReply& reply = states_[place].reply;
    if (reply.compile && !reply.text_key.empty() && !reply.compile_cached) ++run.compiled;
    run.results.push_back(result_of(place, now));
    if (!run.results.back().text_key.empty()) texts.insert(run.results.back().text_key);
    if (!run.results.back().module_key.empty()) modules.insert(run.results.back().module_key);
  }
  run.unique_texts = texts.size();
  run.unique_modules = modules.size();
  run.damaged_entries = damaged_;
  return run;
}

// The engine has no cache without a folder, nor where every unit is compiled by itself.
EngineOptions with_cache_folder(EngineOptions options) {
  if (options.emitted) {
    options.cache.clear();
    options.sharing = Sharing::declarations;
  }
  if (!options.cache.empty() && !platform::make_cache_folder(options.cache)) options.cache.clear();
  return options;
}

}  // namespace

fs::path default_cache() {
  return platform::cache_directory("validation");
}

EngineRun run_units(const std::vector<CompileUnit>& units, const EngineOptions& given) {
  const EngineOptions options = with_cache_folder(given);
  UnitRun run(units, options);
  run.recall();
  run.work();
  platform::trim_cache_when_due(options.cache, entry_kinds, options.cache_limit, run.written());
  return run.take();
}

int serve_units(const std::vector<std::string>& targets_with_drivers) {
  UnitService service;
  return platform::serve_worker(
      [&](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
      [&](const platform::WorkerLimits& limits) {
        open_drivers(targets_with_drivers);
        if (std::find(targets_with_drivers.begin(), targets_with_drivers.end(), fxc_target) !=
            targets_with_drivers.end())
          service.start_fxc(fxc::limits_of(limits));
      });
}

}  // namespace penumbra::validation
