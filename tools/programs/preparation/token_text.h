// Preprocessed HLSL as a list of tokens that passes edit, each token with its source line.
//
// A pass collects edits while it reads and applies them at the end, so indices stay valid meanwhile. Inserted
// text gets the line of the token that it replaces or follows. Printing restores every token's line (with
// #line directives where lines are not consecutive), whatever was inserted or removed.
#pragma once

#include <deque>
#include <initializer_list>
#include <memory>
#include <optional>

#include "hlsl/declarations.h"
#include "hlsl/diagnostic.h"
#include "hlsl/string_interner.h"
#include "hlsl/tokens.h"

namespace penumbra::preparation {

inline constexpr std::size_t npos = static_cast<std::size_t>(-1);

class ValueTypes;

// A message at a token. The preprocessor keeps no columns: `rank` and `count` identify the token among those
// of the given line with the same spelling (hlsl::column_in); a count of 0 means that it was inserted.
struct Note : hlsl::Diagnostic {
  std::string spelling{};
  std::size_t rank = 0;
  std::size_t count = 0;
};

class TokenText {
 public:
  // `preprocessed` has no comments and no macros, but #line directives for source locations. Lines before the
  // first #line that names a file are in `main_file`.
  TokenText(std::string preprocessed, std::string main_file);
  TokenText(const TokenText&) = delete;
  TokenText& operator=(const TokenText&) = delete;

  const std::vector<hlsl::Token>& tokens() const { return tokens_; }
  std::size_t size() const { return tokens_.size(); }
  const hlsl::Token& operator[](std::size_t at) const { return tokens_[at]; }
  bool is(std::size_t at, std::string_view spelling) const {
    return at < tokens_.size() && !spelling.empty() && leads_[at] == spelling[0] &&
           tokens_[at].spelling == spelling;
  }
  template <typename... Spellings>
  bool is_any(std::size_t at, Spellings... spellings) const {
    return (is(at, spellings) || ...);
  }
  bool is_identifier(std::size_t at) const {
    return at < tokens_.size() && hlsl::begins_identifier(leads_[at]);
  }
  bool is_number(std::size_t at) const { return tokens_[at].kind == hlsl::Token::Kind::number; }
  std::string_view word(std::size_t at) const { return tokens_[at].spelling; }
  std::string name(std::size_t at) const { return std::string(word(at)); }
  // Returns the first character of a token; '\0' past the last.
  char lead(std::size_t at) const { return at < tokens_.size() ? leads_[at] : '\0'; }
  // Returns the number of the identifier at this index, equal for equal spellings, below identifier_count();
  // hlsl::StringInterner::none for other tokens.
  std::uint32_t identifier_number(std::size_t at) const {
    return at < tokens_.size() ? numbers_[at] : hlsl::StringInterner::none;
  }
  std::size_t identifier_count() const { return words_.size(); }
  // Returns the token that closes the (, [ or { at this index, or opens the ), ] or } there; npos for other
  // tokens and for unbalanced ones.
  std::size_t matching_bracket(std::size_t at) const {
    return at < tokens_.size() && matching_brackets_[at] != alone ? matching_brackets_[at] : npos;
  }
  // Returns one past the bracket that matches the one at this index, or past this index.
  std::size_t after(std::size_t at) const {
    const std::size_t match = matching_bracket(at);
    return match == npos || match < at ? at + 1 : match + 1;
  }
  // Returns one past the last of `[...][...]` that begin here: sizes, subscripts or attributes.
  std::size_t after_subscripts(std::size_t at) const {
    while (is(at, "[") && matching_bracket(at) != npos) at = matching_bracket(at) + 1;
    return at;
  }
  bool has(std::size_t first, std::size_t end, std::string_view spelling) const;  // among [first, end)
  std::string spelled(std::size_t first, std::size_t count) const;                // as printed, on one line

  // These are the declarations at file scope (hlsl/declarations.h), and the types of the names in the text
  // (value_types.h). They are computed once for all passes until one of them edits; the references are valid
  // until apply().
  const std::vector<hlsl::Declaration>& declarations() const;
  const ValueTypes& types() const;
  // Returns `wanted`, with underscores appended if the text already has that identifier.
  std::string free_name(std::string wanted) const;

  // These edit the text; their ranges must not overlap, and several inserts at one place keep their order.
  void replace(std::size_t first, std::size_t count, std::string_view hlsl);
  void insert(std::size_t before, std::string_view hlsl) { replace(before, 0, hlsl); }
  // Inserts the same with the line of the token `place`, for text that is moved.
  void insert_from(std::size_t place, std::size_t before, std::string_view hlsl);
  // Inserts the same at line 0, for functions that have no place in the source: glslang gives their
  // instructions none, and a rule finds that of the call (lint/divergent_operations.cpp).
  void insert_without_line(std::size_t before, std::string_view hlsl);
  void erase(std::size_t first, std::size_t count) { replace(first, count, {}); }
  void apply();  // all of them at once

  // Records a message at a token's source location.
  void note(std::size_t at, hlsl::Severity severity, std::string message);
  void error(std::size_t at, std::string message) { note(at, hlsl::Severity::error, std::move(message)); }
  void warn(std::size_t at, std::string message) { note(at, hlsl::Severity::warning, std::move(message)); }
  const std::vector<Note>& notes() const { return notes_; }

  // Returns the entry point's name, which is empty for a text without one.
  const std::string& entry() const { return entry_; }
  void set_entry(std::string name) { entry_ = std::move(name); }

  std::string file_of(std::size_t at) const;  // main_file before the first #line that names one
  std::string print() const;

 private:
  struct Edit {
    std::size_t first;
    std::size_t count;
    std::string text;
    std::size_t place = npos;  // the token whose line it gets; npos for the one that it replaces or follows
    bool has_line = true;
  };

  void match_brackets();
  // Returns the token's index in the text as it was given, and those tokens; npos for an inserted one.
  std::size_t original(std::size_t at);
  void append_kept(std::size_t first, std::size_t end);
  void append_made(const Edit& edit);
  std::uint32_t number_of(const hlsl::Token& token);

  std::string text_;
  std::string main_file_;
  std::string entry_;
  std::vector<hlsl::Token> tokens_;
  hlsl::StringInterner words_;          // all identifiers that are or were in the text
  std::vector<std::uint32_t> numbers_;  // number of every token's identifier
  std::string leads_;                   // the first character of every token, for fast tests
  std::vector<hlsl::Token> edited_;     // output of apply() for these three; kept to reuse their memory
  std::vector<std::uint32_t> edited_numbers_;
  std::string edited_leads_;
  static constexpr std::uint32_t alone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> matching_brackets_;
  std::vector<Edit> edits_;
  std::deque<std::string> made_;  // the spellings of inserted tokens
  std::vector<Note> notes_;
  std::vector<hlsl::Token> original_;  // the tokens before the first edit, when a note asks for them
  // They are computed on demand, and valid until apply().
  mutable std::optional<std::vector<hlsl::Declaration>> declarations_;
  mutable std::shared_ptr<const ValueTypes> types_;
  mutable std::vector<bool> known_words_;  // for each number: the identifier is in the text
};

}  // namespace penumbra::preparation
