#include "validation/validate_techniques.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "platform/interrupt.h"
#include "shaders/cross_compile.h"
#include "shaders/gl_check.h"
#include "validation/source_variants.h"

namespace penumbra::validation {

namespace {

// Emits the module for one target and, where there is a driver for it, has it compiled.
std::vector<hlsl::Diagnostic> try_target(const std::vector<std::uint32_t>& spirv, hlsl::Stage stage,
                                         shaders::Target target) {
  shaders::CrossCompileResult emitted = shaders::cross_compile(spirv, target);
  if (hlsl::has_errors(emitted.diagnostics) || !shaders::is_gl(target)) return emitted.diagnostics;
  return shaders::gl_check({{stage, emitted.text}}, target);
}

// Many variants become the same module (presets are uniforms): each pair of module and target is tried once,
// by the first thread that needs it, while others wait for its answer.
class ModuleResults {
 public:
  std::vector<hlsl::Diagnostic> get(const std::vector<std::uint32_t>& spirv, hlsl::Stage stage,
                                    const std::string& target) {
    const std::shared_ptr<Entry> entry = find({spirv, target});
    std::call_once(entry->once, [&] {
      if (const std::optional<shaders::Target> known = shaders::find_target(target))
        entry->diagnostics = try_target(spirv, stage, *known);
    });
    return entry->diagnostics;
  }
  std::size_t size() const { return entries_.size(); }

 private:
  using Key = std::pair<std::vector<std::uint32_t>, std::string>;
  struct Entry {
    std::once_flag once;
    std::vector<hlsl::Diagnostic> diagnostics;
  };

  std::shared_ptr<Entry> find(Key key) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::shared_ptr<Entry>& entry = entries_[std::move(key)];
    if (!entry) entry = std::make_shared<Entry>();
    return entry;
  }

  std::mutex mutex_;
  std::map<Key, std::shared_ptr<Entry>> entries_;
};

// A target that techniques.json gives up on is tried all the same, so that the entry goes when it can.
void judge(VariantRecord& record, const shaders::Technique* technique) {
  const bool failed = hlsl::has_errors(record.diagnostics);
  record.status = failed ? VariantStatus::failed : VariantStatus::passed;
  if (technique == nullptr) return;
  const auto absent = technique->targets_absent.find(record.target);
  if (absent == technique->targets_absent.end()) return;
  record.reason = absent->second;
  if (failed) {
    record.status = VariantStatus::absent;
  } else {
    record.diagnostics.push_back({record.file,
                                  0,
                                  0,
                                  hlsl::Severity::note,
                                  "works, although techniques.json lists it as absent: " + absent->second,
                                  {}});
  }
}

std::vector<VariantRecord> validate_variant(const SourceVariant& variant,
                                            const std::vector<std::string>& targets, ModuleResults& results) {
  shaders::CompileResult compiled = shaders::compile(variant.compile);
  std::vector<VariantRecord> records;
  const bool spirv_asked = std::find(targets.begin(), targets.end(), "spirv") != targets.end();
  for (const std::string& target : targets) {
    VariantRecord record;
    record.technique = variant.technique == nullptr ? "" : variant.technique->name;
    record.file = variant.reported_file;
    record.entry = variant.compile.entry;
    record.stage = variant.compile.stage;
    record.keywords = variant.keywords;
    record.target = target;
    const bool reports_compile = target == "spirv" || (!spirv_asked && target == targets.front());
    if (reports_compile) record.diagnostics = compiled.diagnostics;
    if (!compiled.spirv.empty()) {
      const std::vector<hlsl::Diagnostic> more = results.get(compiled.spirv, variant.compile.stage, target);
      record.diagnostics.insert(record.diagnostics.end(), more.begin(), more.end());
    }
    judge(record, variant.technique);
    if (compiled.spirv.empty() && !reports_compile) record.status = VariantStatus::unreached;
    records.push_back(std::move(record));
  }
  return records;
}

// The loop of every worker; the first exception of any ends all.
class Run {
 public:
  Run(const ValidationRequest& request, const std::vector<SourceVariant>& variants)
      : request_(request), variants_(variants), records_(variants.size()) {}

  void work() {
    try {
      for (std::size_t i = next_++; i < variants_.size() && !stop_; i = next_++) {
        platform::throw_if_interrupted();
        records_[i] = validate_variant(variants_[i], request_.targets, results_);
        report_progress();
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop_ = true;
    }
  }

  ValidationReport take() {
    if (failure_) std::rethrow_exception(failure_);
    ValidationReport report;
    for (std::vector<VariantRecord>& records : records_)
      std::move(records.begin(), records.end(), std::back_inserter(report.records));
    report.unique = results_.size();
    return report;
  }

 private:
  void report_progress() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (request_.progress) request_.progress(done_, variants_.size());
  }

  const ValidationRequest& request_;
  const std::vector<SourceVariant>& variants_;
  std::vector<std::vector<VariantRecord>> records_;
  ModuleResults results_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

std::string checked_by(const std::string& target) {
  if (target == "spirv") return "glslang, then SPIRV-Tools for Vulkan 1.1";
  const std::optional<shaders::Target> known = shaders::find_target(target);
  if (known && shaders::is_gl(*known))
    return "compiled and linked by OpenGL driver " + shaders::gl_driver(*known);
  return "emitted by SPIRV-Cross, not compiled";
}

}  // namespace

ValidationReport validate(const ValidationRequest& request) {
  const auto start = std::chrono::steady_clock::now();
  std::map<std::string, std::string> checks;  // first, so that a missing driver is said at once
  for (const std::string& target : request.targets) checks[target] = checked_by(target);
  const std::vector<SourceVariant> variants = source_variants(request);
  Run run(request, variants);
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < request.jobs; ++i) workers.emplace_back([&run] { run.work(); });
  run.work();
  for (std::thread& worker : workers) worker.join();
  ValidationReport report = run.take();
  report.checks = std::move(checks);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace penumbra::validation
