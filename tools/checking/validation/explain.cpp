#include "validation/explain.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "hlsl/expanded_text.h"
#include "platform/worker_pool.h"
#include "validation/answer_unit.h"
#include "validation/unit_message.h"

namespace penumbra::validation {

namespace {

class TextOfUnit final : public platform::WorkSource {
 public:
  explicit TextOfUnit(const CompileUnit& unit) : unit_(unit) {
    UnitJob job;
    job.unit = unit;
    job.text_only = true;
    message_ = {0, encode(job)};
  }

  std::optional<platform::WorkerMessage> next(unsigned) override {
    return std::exchange(message_, std::nullopt);
  }
  std::string answer_question(std::size_t, const std::string&) override { return std::string(answer_mine); }
  void finished(std::size_t, platform::WorkerOutcome outcome) override {
    std::optional<UnitReply> reply = outcome.failure.empty() ? decode_reply(outcome.answer) : std::nullopt;
    if (!reply) {
      explanation.diagnostics.push_back(
          {unit_.file, 0, 0, hlsl::Severity::error, "the preprocessor " + outcome.failure, {}});
      return;
    }
    if (reply->compile) explanation.diagnostics = std::move(reply->compile->diagnostics);
    explanation.text = with_origins(reply->text, unit_.compile.file.string());
  }

  Explanation explanation;

 private:
  const CompileUnit& unit_;
  std::optional<platform::WorkerMessage> message_;
};

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

std::string with_origins(const std::string& preprocessed, const std::string& main_file) {
  std::string text;
  std::string file;
  for (const hlsl::CodeLine& line : hlsl::expanded_lines(preprocessed, main_file)) {
    if (is_blank(line.text)) continue;
    if (line.file != file) text.append("// ").append(file = line.file).append("\n");
    text.append("/* ").append(std::to_string(line.line)).append(" */ ").append(line.text).append("\n");
  }
  return text;
}

Explanation explain(const CompileUnit& unit, const EngineOptions& options) {
  TextOfUnit source(unit);
  if (options.worker_arguments.empty()) {
    UnitService service;
    platform::run_in_threads(
        1,
        [&service](const std::string& job, platform::WorkerLink& link) { return service.answer(job, link); },
        source);
  } else {
    platform::run_workers({options.worker_arguments, 1, options.limits}, source);
  }
  return std::move(source.explanation);
}

}  // namespace penumbra::validation
