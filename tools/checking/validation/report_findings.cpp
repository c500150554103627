#include "validation/report_findings.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "input/visible_text.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

bool continues(char c) {
  return (static_cast<std::uint8_t>(c) & 0xC0U) == 0x80U;
}

// Returns the bytes of the well-formed sequence that starts the text (Unicode 15, table 3-7), or 0 where
// there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), continues)) return 0;
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) > 0x9F;
  const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

// Returns whether a diagnostic is about text that SPIRV-Cross emitted: gl_check() gives the target instead of
// a file.
bool in_emitted_text(const hlsl::Diagnostic& diagnostic, const VariantRecord& record) {
  return diagnostic.file == record.target;
}

bool worth_telling(const hlsl::Diagnostic& diagnostic, const VariantRecord& record) {
  const bool of_source = diagnostic.line > 0 && !in_emitted_text(diagnostic, record);
  return diagnostic.severity != hlsl::Severity::warning || is_spirv_target(record.target) || of_source;
}

std::string rule_of(const hlsl::Diagnostic& diagnostic, const VariantRecord& record) {
  if (!diagnostic.rule.empty()) return diagnostic.rule;
  if (diagnostic.message.starts_with("SPIR-V ")) return "spirv";
  if (diagnostic.line > 0 && !in_emitted_text(diagnostic, record)) return "hlsl";
  return is_spirv_target(record.target) ? "hlsl" : "target-" + record.target;
}

std::string of_any_precision(std::string message) {
  for (const std::string_view name : {"min16float", "min10float"})
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
      message.replace(at, name.size(), "half");
  return message;
}

// Both names are lexically normal, or not at all below each other.
bool is_in(const std::string& file, const std::vector<std::string>& folders) {
  return std::any_of(folders.begin(), folders.end(), [&](const std::string& folder) {
    return file.starts_with(folder) && (file.size() == folder.size() || file[folder.size()] == '/');
  });
}

// FNV-1a with 64 bits and 16 digits is stable across machines and versions of this program.
std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3U;
  constexpr char digits[] = "0123456789abcdef";
  std::string hex(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4U) hex[i] = digits[hash & 15U];
  return hex;
}

void leave_to_package(Finding& finding, const ValidationReport& report) {
  const bool of_package =
      std::all_of(finding.records.begin(), finding.records.end(),
                  [&](std::size_t record) { return is_in(report.records[record].file, report.packages); });
  const bool error = finding.diagnostic.severity == hlsl::Severity::error;
  if (!of_package && (error || !is_in(finding.diagnostic.file, report.packages))) return;
  finding.in_package = true;
  finding.diagnostic.severity = hlsl::Severity::note;
}

class Folder {
 public:
  void add(const hlsl::Diagnostic& diagnostic, const VariantRecord& record, std::size_t index) {
    hlsl::Diagnostic told = as_told(diagnostic, record);
    const Key key{told.file, told.line, told.column, told.severity, of_any_precision(told.message),
                  told.rule};
    const auto [at, is_new] = index_.try_emplace(key, findings_.size());
    if (is_new) findings_.push_back({std::move(told), rule_of(diagnostic, record), {}});
    std::vector<std::size_t>& records = findings_[at->second].records;
    if (records.empty() || records.back() != index) records.push_back(index);
  }

  std::vector<Finding> take() { return std::move(findings_); }

 private:
  using Key = std::tuple<std::string, int, int, hlsl::Severity, std::string, std::string>;
  std::map<Key, std::size_t> index_;
  std::vector<Finding> findings_;
};

// A variant of the finding's programs, and whether it has the finding.
struct Candidate {
  const std::vector<std::uint32_t>* keywords = nullptr;  // numbers, rising
  bool has_it = false;

  bool has(std::uint32_t keyword) const {
    return std::binary_search(keywords->begin(), keywords->end(), keyword);
  }
};

// Returns the variants by program, then in the order of their first records.
std::vector<std::size_t> variants_with(const Finding& finding, const Variants& variants) {
  std::set<std::pair<std::size_t, std::size_t>> found;
  for (const std::size_t record : finding.records) {
    const std::size_t variant = variants.of_record(record);
    found.emplace(variants[variant].program, variant);
  }
  std::vector<std::size_t> having;
  for (const auto& [program, variant] : found) having.push_back(variant);
  return having;
}

std::vector<std::size_t> programs_of(const std::vector<std::size_t>& having, const Variants& variants) {
  std::vector<std::size_t> programs;
  for (const std::size_t variant : having)
    if (programs.empty() || programs.back() != variants[variant].program)
      programs.push_back(variants[variant].program);
  return programs;
}

std::vector<Candidate> candidates(const std::vector<std::size_t>& having, const Variants& variants) {
  const std::set<std::size_t> have_it(having.begin(), having.end());
  std::vector<Candidate> all;
  for (const std::size_t program : programs_of(having, variants))
    for (const std::size_t variant : variants.of_program(program))
      all.push_back({&variants.keyword_numbers(variant), have_it.contains(variant)});
  return all;
}

// The numbers of candidates that have each keyword, among those that have the finding and among the others.
using Counts = std::map<std::uint32_t, std::pair<std::size_t, std::size_t>>;

Counts count_keywords(const std::vector<Candidate>& all) {
  Counts counts;
  for (const Candidate& candidate : all)
    for (const std::uint32_t keyword : *candidate.keywords) {
      auto& [having, others] = counts[keyword];
      ++(candidate.has_it ? having : others);
    }
  return counts;
}

// The candidates without the finding that each keyword distinguishes from those with it. A keyword that all
// of those have distinguishes the candidates without it; a keyword that none of those has distinguishes the
// candidates with it.
class Distinction {
 public:
  Distinction(const std::vector<Candidate>& all, const std::vector<std::uint32_t>& with,
              const std::vector<std::uint32_t>& without)
      : reasons_(all.size()) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].has_it) continue;
      for (const std::uint32_t keyword : with)
        if (!all[i].has(keyword)) add(keyword, i);
      for (const std::uint32_t keyword : *all[i].keywords)
        if (std::binary_search(without.begin(), without.end(), keyword)) add(keyword, i);
      complete_ = complete_ && reasons_[i] > 0;
    }
  }

  // Returns whether all keywords together distinguish all candidates without the finding.
  bool complete() const { return complete_; }

  // Returns whether they do so without this keyword, which then no longer counts.
  bool drop(std::uint32_t keyword) {
    const std::vector<std::size_t>& apart = apart_[keyword];
    if (std::any_of(apart.begin(), apart.end(), [this](std::size_t i) { return reasons_[i] == 1; }))
      return false;
    for (const std::size_t i : apart) --reasons_[i];
    return true;
  }

 private:
  void add(std::uint32_t keyword, std::size_t candidate) {
    apart_[keyword].push_back(candidate);
    ++reasons_[candidate];
  }

  std::vector<std::size_t> reasons_;  // the number of distinguishing keywords for each candidate
  std::map<std::uint32_t, std::vector<std::size_t>> apart_;
  bool complete_ = true;
};

void drop_needless(Distinction& distinction, std::vector<std::uint32_t>& keywords) {
  for (std::size_t i = keywords.size(); i-- > 0;)
    if (distinction.drop(keywords[i])) keywords.erase(keywords.begin() + static_cast<std::ptrdiff_t>(i));
}

// Distinguishing keywords are sought for few variants among few, or among a moderate multiple. So the work
// grows with the report, and not with the product of its findings and its variants.
bool can_be_told_apart(const KeywordFold& fold) {
  constexpr std::size_t kFew = 1024;
  constexpr std::size_t kMultiple = 256;
  return fold.in > 1 && fold.in < fold.of && fold.of <= std::max(kFew, kMultiple * fold.in);
}

void tell_apart(const std::vector<Candidate>& all, const Variants& variants, KeywordFold& fold) {
  std::vector<std::uint32_t> with;
  std::vector<std::uint32_t> without;
  for (const auto& [keyword, count] : count_keywords(all)) {
    if (count.first == fold.in && count.second < fold.of - fold.in) with.push_back(keyword);
    if (count.first == 0) without.push_back(keyword);
  }
  Distinction distinction(all, with, without);
  fold.exact = distinction.complete();
  if (fold.exact) {
    drop_needless(distinction, without);
    drop_needless(distinction, with);
    for (const std::uint32_t keyword : without) fold.without.push_back(variants.keyword(keyword));
  }
  for (const std::uint32_t keyword : with) fold.with.push_back(variants.keyword(keyword));
}

std::string keyword_list(const std::vector<std::string>& keywords) {
  return keywords.empty() ? "no keyword" : shortened(keywords, " ", 6);
}

}  // namespace

// The location must be one that can be opened: a line of emitted text cannot.
hlsl::Diagnostic as_told(hlsl::Diagnostic diagnostic, const VariantRecord& record) {
  if (in_emitted_text(diagnostic, record)) {
    diagnostic.message = "the generated text is rejected: " + diagnostic.message;
    diagnostic.file.clear();
    diagnostic.line = diagnostic.column = 0;
    diagnostic.source_line.clear();
  }
  if (diagnostic.file.empty()) diagnostic.file = record.file;
  return diagnostic;
}

std::vector<Finding> findings(const ValidationReport& report, const ReportStyle& style) {
  Folder folder;
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    const VariantRecord& record = report.records[i];
    // The reason of such records is reported instead; the error is reported at "spirv" or cannot be
    // determined here.
    const bool told_otherwise =
        record.status == VariantStatus::absent || record.status == VariantStatus::unchecked;
    bool has_error = false;
    for (const hlsl::Diagnostic& diagnostic : record.diagnostics) {
      const bool error = diagnostic.severity == hlsl::Severity::error;
      has_error = has_error || error;
      if (worth_telling(diagnostic, record) && !(told_otherwise && error)) folder.add(diagnostic, record, i);
    }
    if (record.status == VariantStatus::failed && !has_error)
      folder.add({record.file, 0, 0, hlsl::Severity::error, "failed without a message", {}}, record, i);
  }
  std::vector<Finding> all = folder.take();
  if (!report.packages.empty())
    for (Finding& finding : all) leave_to_package(finding, report);
  if (!style.known) return all;
  const std::vector<std::string> keys = finding_keys(all, style);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].known = style.known->contains(keys[i]);
  return all;
}

std::vector<std::string> finding_keys(const std::vector<Finding>& findings, const ReportStyle& style) {
  std::vector<std::string> keys;
  std::map<std::string, int> met;
  for (const Finding& finding : findings) {
    const hlsl::Diagnostic& said = finding.diagnostic;
    const std::string code = digest(finding.rule + '\n' + relative_file(said.file, style) + '\n' +
                                    said.message + '\n' + said.source_line);
    keys.push_back(code + ":" + std::to_string(++met[code]));
  }
  return keys;
}

bool is_shown(const Finding& finding, const ReportStyle& style) {
  const hlsl::Diagnostic& said = finding.diagnostic;
  const bool decision = said.severity == hlsl::Severity::note && said.rule.empty() && said.line > 0;
  return style.verbose || (!decision && !finding.in_package && !finding.known);
}

Verdict verdict_of(const std::vector<Finding>& findings, const ReportStyle& style) {
  std::map<hlsl::Severity, std::size_t> count;
  std::size_t known = 0;
  for (const Finding& finding : findings) {
    if (finding.diagnostic.severity == hlsl::Severity::note) continue;
    ++(finding.known ? known : count[finding.diagnostic.severity]);
  }
  const std::size_t errors = count[hlsl::Severity::error];
  const std::size_t warnings = count[hlsl::Severity::warning];
  std::vector<std::string> parts;
  if (errors != 0) parts.push_back(counted(errors, "error"));
  if (warnings != 0) parts.push_back(counted(warnings, "warning"));
  if (known != 0) parts.push_back(counted(known, "finding") + " of the baseline");
  const bool failed = errors != 0 || (style.werror && warnings != 0);
  return {failed, (failed ? "failed" : "passed") + (parts.empty() ? "" : ": " + joined(parts, ", "))};
}

bool fails(const ValidationReport& report, const ReportStyle& style) {
  return verdict_of(findings(report, style), style).failed;
}

Variants::Variants(const ValidationReport& report) {
  using Program = std::tuple<std::string, std::string, std::string, std::string, std::string, hlsl::Stage>;
  std::map<Program, std::size_t> programs;
  std::map<std::pair<std::size_t, std::vector<std::string>>, std::size_t> known;
  for (const VariantRecord& record : report.records) {
    const Program names{record.technique, record.file,  record.shader,
                        record.pass,      record.entry, record.stage};
    const std::size_t program = programs.try_emplace(names, programs.size()).first->second;
    of_program_.resize(programs.size());
    const auto [at, is_new] = known.try_emplace({program, record.keywords}, variants_.size());
    if (is_new) {
      variants_.push_back({program, record.keywords});
      std::sort(variants_.back().keywords.begin(), variants_.back().keywords.end());
      of_program_[program].push_back(at->second);
    }
    of_record_.push_back(at->second);
  }
  for (const Variant& variant : variants_)
    keywords_.insert(keywords_.end(), variant.keywords.begin(), variant.keywords.end());
  std::sort(keywords_.begin(), keywords_.end());
  keywords_.erase(std::unique(keywords_.begin(), keywords_.end()), keywords_.end());
  for (const Variant& variant : variants_) {
    std::vector<std::uint32_t>& numbers = numbers_.emplace_back();
    for (const std::string& keyword : variant.keywords)
      numbers.push_back(static_cast<std::uint32_t>(
          std::lower_bound(keywords_.begin(), keywords_.end(), keyword) - keywords_.begin()));
  }
}

KeywordFold fold_keywords(const Finding& finding, const Variants& variants) {
  const std::vector<std::size_t> having = variants_with(finding, variants);
  KeywordFold fold;
  fold.in = having.size();
  for (const std::size_t program : programs_of(having, variants))
    fold.of += variants.of_program(program).size();
  const auto smallest = std::min_element(having.begin(), having.end(), [&](std::size_t a, std::size_t b) {
    return variants[a].keywords.size() < variants[b].keywords.size();
  });
  if (smallest != having.end()) fold.example = variants[*smallest].keywords;
  if (can_be_told_apart(fold)) tell_apart(candidates(having, variants), variants, fold);
  return fold;
}

std::string program_title(const VariantRecord& record) {
  std::string text = record.technique.empty() ? "" : "technique " + record.technique + ", ";
  if (!record.pass.empty()) text += "pass " + record.pass + (record.shader.empty() ? ", " : " of ");
  if (!record.shader.empty()) text += record.shader + ", ";
  if (!record.entry.empty()) return visible(text + hlsl::stage_name(record.stage) + " entry " + record.entry);
  // The record is of a file or a pass as a whole.
  return visible(text.empty() ? record.file : text.substr(0, text.size() - 2));
}

std::string program_titles(const Finding& finding, const ValidationReport& report, const Variants& variants) {
  std::vector<std::string> titles;
  std::set<std::size_t> known;
  for (const std::size_t record : finding.records)
    if (known.insert(variants[variants.of_record(record)].program).second)
      titles.push_back(program_title(report.records[record]));
  return shortened(titles, " and ", 1);
}

std::string fold_sentence(const KeywordFold& fold) {
  if (fold.of == 1) return fold.example.empty() ? "" : "with " + keyword_list(fold.example);
  if (fold.in == fold.of) return "in all " + std::to_string(fold.of) + " variants";
  std::string text = "in " + std::to_string(fold.in) + " of " + std::to_string(fold.of) + " variants";
  if (fold.in == 1) return text + ": with " + keyword_list(fold.example);
  if (fold.exact) {
    if (!fold.with.empty()) text += ": all with " + shortened(fold.with, " ", 6);
    if (!fold.without.empty())
      text += (fold.with.empty() ? ": all without " : " and without ") + shortened(fold.without, " ", 6);
    return text;
  }
  if (!fold.with.empty()) text += "; always with " + shortened(fold.with, " ", 6);
  return text + "; for example with " + keyword_list(fold.example);
}

std::vector<std::string> targets_of(const Finding& finding, const ValidationReport& report) {
  std::vector<std::string> targets;
  std::set<std::string> known;
  for (const std::size_t record : finding.records)
    if (known.insert(report.records[record].target).second) targets.push_back(report.records[record].target);
  return targets;
}

std::string crash_text(const ValidationReport& report) {
  std::vector<std::string> crashes;
  const Variants variants(report);
  for (const Finding& finding : findings(report)) {
    if (finding.rule != compiler_crash) continue;
    const VariantRecord& first = report.records[finding.records.front()];
    std::string text = finding.diagnostic.file + ": " + finding.diagnostic.message + ": " +
                       program_titles(finding, report, variants) + ", with " + keyword_list(first.keywords) +
                       ", for " + joined(targets_of(finding, report), ", ");
    if (!first.reproduction.empty()) text += "; its text is in " + first.reproduction;
    crashes.push_back(visible(text));
  }
  return shortened(crashes, "\n  ", 4);
}

Totals totals_of(const ValidationReport& report, const Variants& variants) {
  Totals totals;
  std::set<std::string> targets;
  std::set<std::size_t> compiled;
  for (std::size_t i = 0; i < report.records.size(); ++i) {
    const VariantRecord& record = report.records[i];
    const bool whole = record.target == whole_source;
    // The record has only a message.
    if (whole && record.status == VariantStatus::passed) continue;
    ++totals.results;
    totals.cached += record.cached ? 1 : 0;
    if (whole) continue;
    compiled.insert(variants.of_record(i));
    targets.insert(record.target);
  }
  totals.variants = compiled.size();
  totals.targets = targets.size();
  return totals;
}

std::string totals_line(const ValidationReport& report, const Variants& variants) {
  const Totals totals = totals_of(report, variants);
  std::string text;
  if (report.shards > 1)
    text = "shard " + std::to_string(report.shard) + " of " + std::to_string(report.shards) + ": ";
  text += counted(totals.variants, "variant") + " for " + counted(totals.targets, "target") + ": " +
          counted(totals.results, "result") + " (" + std::to_string(report.unique) + " unique, " +
          std::to_string(totals.cached) + " cached), " + std::to_string(report.count(VariantStatus::failed)) +
          " failed";
  for (const VariantStatus status :
       {VariantStatus::absent, VariantStatus::unreached, VariantStatus::unchecked})
    if (const std::size_t count = report.count(status); count != 0)
      text += ", " + std::to_string(count) + " " + status_name(status);
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, ", %.1f s", report.seconds);
  return text + seconds;
}

std::string joined(const std::vector<std::string>& parts, const char* separator) {
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "" : separator).append(part);
  return text;
}

std::string shortened(const std::vector<std::string>& parts, const char* separator, std::size_t most) {
  if (parts.size() <= most + 1) return joined(parts, separator);
  const std::vector<std::string> first(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(most));
  return joined(first, separator) + " and " + std::to_string(parts.size() - most) + " more";
}

std::string relative_file(const std::string& file, const ReportStyle& style) {
  const std::filesystem::path given = std::filesystem::path(file).lexically_normal();
  const std::filesystem::path path = (style.folder / given).lexically_normal();
  if (style.root.empty() || !path.is_absolute()) return given.generic_string();
  const std::filesystem::path relative = path.lexically_relative(style.root.lexically_normal());
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below ? relative : path).generic_string();
}

std::string uri_of(const std::string& file) {
  constexpr char digits[] = "0123456789ABCDEF";
  const std::string path = std::filesystem::path(file).generic_string();
  std::string uri =
      std::filesystem::path(file).is_absolute() ? path.front() == '/' ? "file://" : "file:///" : "";
  for (const char c : path) {
    const auto byte = static_cast<std::uint8_t>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) != 0 ||
                                       std::string_view("/-._~").find(c) != std::string_view::npos);
    if (plain) {
      uri += c;
    } else {
      uri.append(1, '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    }
  }
  return uri;
}

int column_in_characters(std::string_view line, int column) {
  const std::size_t before = std::min(line.size(), static_cast<std::size_t>(std::max(column - 1, 0)));
  const auto end = line.begin() + static_cast<std::ptrdiff_t>(before);
  return column - static_cast<int>(std::count_if(line.begin(), end, continues));
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    valid += length == 0 ? replacement : text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return valid;
}

}  // namespace penumbra::validation
