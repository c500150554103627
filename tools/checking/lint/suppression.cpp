#include "lint/suppression.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "input/nearest_name.h"
#include "lint/rule.h"

namespace penumbra::lint {

namespace {

constexpr std::string_view mark = "penumbra-lint:";

struct Comment {
  int line = 0;
  bool alone = false;  // true if only white space stands before it
  bool whole_file = false;
  struct Name {
    std::string text;
    int column = 0;
  };
  std::vector<Name> names;
};

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

bool take(std::string_view& rest, std::string_view word) {
  if (rest.substr(0, word.size()) != word) return false;
  rest.remove_prefix(word.size());
  return true;
}

void skip_blanks(std::string_view& rest) {
  while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
}

// Returns the suppression comment of a line, without names if there is none.
Comment comment_of(std::string_view line, int number) {
  Comment comment;
  comment.line = number;
  const std::size_t at = line.find("//");
  if (at == std::string_view::npos) return comment;
  comment.alone = line.find_first_not_of(" \t") == at;
  std::string_view rest = line.substr(at + 2);
  skip_blanks(rest);
  if (!take(rest, mark)) return comment;
  skip_blanks(rest);
  comment.whole_file = take(rest, "disable-file=");
  if (!comment.whole_file && !take(rest, "disable=")) return comment;
  do {
    skip_blanks(rest);
    const std::string_view from = rest;
    while (!rest.empty() && is_name(rest.front())) rest.remove_prefix(1);
    const std::string_view name = from.substr(0, from.size() - rest.size());
    if (!name.empty())
      comment.names.push_back({std::string(name), static_cast<int>(name.data() - line.data()) + 1});
    skip_blanks(rest);
  } while (take(rest, ","));
  return comment;
}

std::vector<Comment> comments_of(const std::string& text) {
  std::vector<Comment> comments;
  if (text.find(mark) == std::string::npos) return comments;
  int number = 1;
  for (std::size_t start = 0; start < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    Comment comment = comment_of(std::string_view(text).substr(start, end - start), number);
    if (!comment.names.empty()) comments.push_back(std::move(comment));
    start = end + 1;
  }
  return comments;
}

struct Silenced {
  std::set<std::string> everywhere;
  std::map<int, std::set<std::string>> on_line;
};

Silenced silenced_in(const std::string& text) {
  Silenced silenced;
  const std::vector<Comment> comments = comments_of(text);
  int below = 0;  // the line after consecutive lines with only such comments
  int last_alone = 0;
  for (std::size_t at = comments.size(); at-- > 0;) {
    const Comment& comment = comments[at];
    if (comment.alone && comment.line + 1 != last_alone) below = comment.line + 1;
    if (comment.alone) last_alone = comment.line;
    const int line = comment.alone ? below : comment.line;
    for (const Comment::Name& name : comment.names) {
      if (comment.whole_file) {
        silenced.everywhere.insert(name.text);
      } else {
        silenced.on_line[line].insert(name.text);
      }
    }
  }
  return silenced;
}

}  // namespace

std::vector<hlsl::Diagnostic> without_suppressed(std::vector<hlsl::Diagnostic> findings,
                                                 const hlsl::SourceFiles& sources) {
  std::map<std::string, Silenced> by_file;
  const auto is_silenced = [&](const hlsl::Diagnostic& finding) {
    if (!sources.contains(finding.file)) return false;
    auto found = by_file.find(finding.file);
    if (found == by_file.end())
      found = by_file.emplace(finding.file, silenced_in(sources.text(finding.file))).first;
    if (found->second.everywhere.contains(finding.rule)) return true;
    const auto line = found->second.on_line.find(finding.line);
    return line != found->second.on_line.end() && line->second.contains(finding.rule);
  };
  std::erase_if(findings, is_silenced);
  return findings;
}

std::vector<hlsl::Diagnostic> unknown_suppressions(const hlsl::SourceFiles& sources) {
  std::vector<std::string> known;
  for (const RuleInfo& rule : rules()) known.push_back(rule.name);
  std::vector<hlsl::Diagnostic> findings;
  for (const std::string& file : sources.names())
    for (const Comment& comment : comments_of(sources.text(file)))
      for (const Comment::Name& name : comment.names) {
        if (find_rule(name.text) != nullptr) continue;
        findings.push_back({file, comment.line, name.column, hlsl::Severity::warning,
                            "this comment disables an unknown rule, '" + name.text + "'; " +
                                unknown_name_remedy(name.text, known),
                            sources.line(file, comment.line), "unknown-rule"});
      }
  return findings;
}

}  // namespace penumbra::lint
