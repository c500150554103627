// The state of a run: the units that wait, those whose results are known, and the unit whose answer others
// share. Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "platform/worker_pool.h"
#include "validation/engine.h"
#include "validation/reproduction.h"
#include "validation/unit_message.h"
#include "validation/waiting_units.h"

namespace penumbra::validation {

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

}  // namespace penumbra::validation
