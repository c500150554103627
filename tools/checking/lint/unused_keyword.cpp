#include <map>
#include <set>
#include <string>

#include "lint/program_rules.h"
#include "lint/rule.h"

namespace penumbra::lint {

namespace {

struct Verdict {
  std::size_t pairs = 0;
  bool changes = false;
};

using Variant = std::pair<std::string, std::set<std::string>>;  // source, keywords

Verdict toggled(const std::map<Variant, std::string>& hash_of, const std::string& keyword) {
  Verdict verdict;
  for (const auto& [variant, hash] : hash_of) {
    if (!variant.second.contains(keyword)) continue;
    Variant without = variant;
    without.second.erase(keyword);
    const auto other = hash_of.find(without);
    if (other == hash_of.end()) continue;
    ++verdict.pairs;
    verdict.changes = verdict.changes || other->second != hash;
  }
  return verdict;
}

}  // namespace

std::vector<hlsl::Diagnostic> unused_keyword_findings(const ProgramKeywords& program) {
  constexpr const char* rule = "unused-keyword";
  std::map<Variant, std::string> hash_of;
  for (const VariantText& variant : program.variants)
    hash_of[{variant.source, {variant.keywords.begin(), variant.keywords.end()}}] = variant.hash;
  std::vector<hlsl::Diagnostic> findings;
  for (const NamedPlace& keyword : program.declared) {
    const Verdict verdict = toggled(hash_of, keyword.name);
    if (verdict.pairs == 0 || verdict.changes) continue;
    const std::string compared = std::to_string(verdict.pairs) + (verdict.pairs == 1 ? " pair" : " pairs");
    findings.push_back({keyword.file.empty() ? program.file : keyword.file,
                        keyword.line,
                        keyword.column,
                        find_rule(rule)->severity,
                        "keyword '" + keyword.name + "' changes nothing in " + program.program + " (" +
                            compared + " of variants compared), but doubles how many are compiled",
                        {},
                        rule});
  }
  return findings;
}

}  // namespace penumbra::lint
