// Groups the records of a report: one cause, however many variants and targets it fails, is one finding.
// Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "input/counted.h"
#include "validation/report.h"

namespace penumbra::validation {

struct Finding {
  hlsl::Diagnostic diagnostic;
  std::string rule;  // the lint rule, or the kind of a compiler's message: "hlsl", "spirv", ...
  std::vector<std::size_t> records;  // indices of the records that have it, in their order
  bool in_package = false;           // see ValidationReport::packages: its severity is that of a note
  bool known = false;                // the baseline has it
};

// Returns the diagnostic as reported in a finding: at a location that can be opened.
hlsl::Diagnostic as_told(hlsl::Diagnostic diagnostic, const VariantRecord& record);

// Returns the findings in the order of their first record. Omits a driver's warnings about generated text; a
// failed record without a message has a finding that says so. Messages that differ only in how a type of less
// than 32 bits is spelt are one: `half` is another type on each graphics API.
std::vector<Finding> findings(const ValidationReport& report, const ReportStyle& style = {});

// Returns a key for each finding that does not change when lines move. Equal findings of one file are
// distinguished by their number.
std::vector<std::string> finding_keys(const std::vector<Finding>& findings, const ReportStyle& style);

// Returns whether a report shows it: not notes about decisions, such as which of two overloads was kept, and
// neither what is in packages nor what the baseline has, unless all is asked for.
bool is_shown(const Finding& finding, const ReportStyle& style);

struct Verdict {
  bool failed = false;
  std::string text;  // "failed: 2 errors, 1 warning", "passed"
};
Verdict verdict_of(const std::vector<Finding>& findings, const ReportStyle& style);

// An entry point with one keyword set, for all targets: a variant from the user's point of view.
struct Variant {
  std::size_t program = 0;            // the entry point: variants of equal program differ in keywords alone
  std::vector<std::string> keywords;  // sorted
};

class Variants {
 public:
  explicit Variants(const ValidationReport& report);

  std::size_t size() const { return variants_.size(); }
  std::size_t of_record(std::size_t record) const { return of_record_[record]; }
  const Variant& operator[](std::size_t index) const { return variants_[index]; }
  const std::vector<std::size_t>& of_program(std::size_t program) const { return of_program_[program]; }
  // Returns the numbers of a variant's keywords in the list of all keywords by name, rising.
  const std::vector<std::uint32_t>& keyword_numbers(std::size_t variant) const { return numbers_[variant]; }
  const std::string& keyword(std::uint32_t number) const { return keywords_[number]; }

 private:
  std::vector<Variant> variants_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // one for each variant
  std::vector<std::string> keywords_;                // all keywords, by name
  std::vector<std::size_t> of_record_;
  std::vector<std::vector<std::size_t>> of_program_;
};

// The variants of a program that have a finding, described with as few keywords as possible.
struct KeywordFold {
  std::size_t in = 0;  // variants that have the finding
  std::size_t of = 0;  // variants of the same programs
  // These are set where several variants have the finding and are not far fewer than the others; for one
  // variant the example is enough.
  std::vector<std::string> with;     // keywords of all that have it, unless all variants have them
  std::vector<std::string> without;  // only if `exact`: keywords that none of them has
  bool exact = false;  // the variants with `with` and without `without` are exactly those that have it
  std::vector<std::string> example;  // the smallest keyword set that has it
};

KeywordFold fold_keywords(const Finding& finding, const Variants& variants);

// Returns the title of a record's program without its file: "ForwardLit of Custom/Water, fragment entry
// Frag".
std::string program_title(const VariantRecord& record);

// Returns the entry point that has the finding, and how many others do.
std::string program_titles(const Finding& finding, const ValidationReport& report, const Variants& variants);

// Returns the sentence for a fold, in all report formats: "4 of 6 variants, always with A". It is empty if
// there is only one variant, without keywords.
std::string fold_sentence(const KeywordFold& fold);

// Returns the targets of the records, each once, in order.
std::vector<std::string> targets_of(const Finding& finding, const ValidationReport& report);

// Numbers of a report. A variant is an entry point with one keyword set, and a result is that of a variant
// for a target, or of a file or program that has none.
struct Totals {
  std::size_t variants = 0;
  std::size_t targets = 0;
  std::size_t results = 0;
  std::size_t cached = 0;
};
Totals totals_of(const ValidationReport& report, const Variants& variants);

// Returns "240 variants for 5 targets: 1200 results (31 unique, 0 cached), 3 failed, ..., 12.3 s".
std::string totals_line(const ValidationReport& report, const Variants& variants);

std::string joined(const std::vector<std::string>& parts, const char* separator);

// Returns the first of them and how many more there are: "A B C and 4 more".
std::string shortened(const std::vector<std::string>& parts, const char* separator, std::size_t most);

// Returns the path relative to the style's root, with '/'; unchanged if it is elsewhere or there is no root.
std::string relative_file(const std::string& file, const ReportStyle& style);

// Returns a relative reference of RFC 3986, or file:///... for an absolute path. Every byte outside of the
// unreserved set and '/' is percent-encoded.
std::string uri_of(const std::string& file);

// Returns the number of Unicode code points before the 1-based byte column, plus one; `line` may be empty.
int column_in_characters(std::string_view line, int column);

// Returns well-formed UTF-8: invalid bytes become U+FFFD.
std::string valid_utf8(std::string_view text);

}  // namespace penumbra::validation
