#include "validation/report_merge.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "input/input_error.h"
#include "validation/report_findings.h"

namespace penumbra::validation {

namespace {

std::string shard_name(const ValidationReport& report) {
  return std::to_string(report.shard) + "/" + std::to_string(report.shards);
}

void check_same_request(const NamedReport& first, const NamedReport& other) {
  if (other.report.fingerprint != first.report.fingerprint)
    throw InputError(other.name, "was made with files or options that differ from those of " + first.name,
                     "make every shard with the same files and options, except --shard and --jobs");
  if (other.report.shards != first.report.shards)
    throw InputError(other.name, "is shard " + shard_name(other.report) + ", but " + first.name +
                                     " is shard " + shard_name(first.report));
  if (other.report.shard == first.report.shard)
    throw InputError(other.name,
                     first.report.shards == 1
                         ? "is a whole run, as " + first.name + " is"
                         : "is shard " + shard_name(other.report) + ", as " + first.name + " is",
                     "give each shard of one run exactly once");
}

void check_shards(const std::vector<NamedReport>& reports) {
  if (reports.empty()) throw InputError("", "no report was given");
  for (std::size_t i = 1; i < reports.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) check_same_request(reports[k], reports[i]);
  const unsigned shards = reports.front().report.shards;
  std::vector<std::string> missing;
  for (unsigned shard = 1; shard <= shards && missing.size() < 100; ++shard) {
    const bool is_there = std::any_of(reports.begin(), reports.end(),
                                      [&](const NamedReport& named) { return named.report.shard == shard; });
    if (!is_there) missing.push_back(std::to_string(shard) + "/" + std::to_string(shards));
  }
  if (!missing.empty())
    throw InputError("",
                     (missing.size() == 1 ? "shard " : "shards ") + joined(missing, ", ") +
                         (missing.size() == 1 ? " is missing" : " are missing"),
                     "run the same command with --shard " + missing.front());
}

using Identity = std::tuple<std::string, std::string, std::string, std::string, std::string, hlsl::Stage,
                            std::vector<std::string>, std::string>;

Identity identity(const VariantRecord& record) {
  return {record.technique, record.file,  record.shader,   record.pass,
          record.entry,     record.stage, record.keywords, record.target};
}

void check_overlap(const std::vector<NamedReport>& reports) {
  std::map<Identity, const NamedReport*> owners;
  for (const NamedReport& named : reports)
    for (const VariantRecord& record : named.report.records) {
      const auto [at, is_new] = owners.try_emplace(identity(record), &named);
      if (is_new || at->second == &named) continue;
      const std::string keywords = record.keywords.empty() ? "" : " with " + joined(record.keywords, " ");
      throw InputError(named.name, "contains a result that " + at->second->name +
                                       " contains, too: " + record.file + ", " + program_title(record) +
                                       keywords + ", " + record.target);
    }
}

// Where machines differ, the check reads "GL 4.5 here; GL 4.6 there".
void add_checks(const std::map<std::string, std::string>& from, std::map<std::string, std::string>& to) {
  for (const auto& [target, check] : from) {
    std::string& known = to[target];
    if (known.empty()) {
      known = check;
    } else if (("; " + known + "; ").find("; " + check + "; ") == std::string::npos) {
      known += "; " + check;
    }
  }
}

// Counts the pairs of module and target that an earlier shard has already counted.
std::size_t met_again(const ValidationReport& report, std::set<std::pair<std::string, std::string>>& known) {
  std::set<std::pair<std::string, std::string>> own;
  for (const VariantRecord& record : report.records)
    if (!record.module.empty()) own.emplace(record.module, record.target);
  std::size_t again = 0;
  for (const auto& pair : own) again += known.insert(pair).second ? 0 : 1;
  return again;
}

}  // namespace

ValidationReport merge_reports(std::vector<NamedReport> reports) {
  check_shards(reports);
  check_overlap(reports);
  std::sort(reports.begin(), reports.end(),
            [](const NamedReport& a, const NamedReport& b) { return a.report.shard < b.report.shard; });
  ValidationReport merged;
  merged.fingerprint = reports.front().report.fingerprint;
  std::set<std::pair<std::string, std::string>> modules;
  for (NamedReport& named : reports) {
    ValidationReport& report = named.report;
    merged.unique += report.unique - std::min(report.unique, met_again(report, modules));
    merged.seconds += report.seconds;
    add_checks(report.checks, merged.checks);
    merged.rules.insert(report.rules.begin(), report.rules.end());
    merged.packages = report.packages;  // those of one command
    std::move(report.minimal.begin(), report.minimal.end(), std::back_inserter(merged.minimal));
    std::move(report.records.begin(), report.records.end(), std::back_inserter(merged.records));
  }
  std::stable_sort(merged.records.begin(), merged.records.end(),
                   [](const VariantRecord& a, const VariantRecord& b) { return a.place < b.place; });
  return merged;
}

}  // namespace penumbra::validation
