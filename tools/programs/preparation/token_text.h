// Preprocessed HLSL as a list of tokens that passes edit, each token with the line it came from.
//
// A pass collects edits while it reads and applies them at the end, so that indices stay valid meanwhile.
// Text that an edit puts in stands on the line of the token it replaces or follows. Printing gives every
// token its own line again (#line directives where lines do not follow each other), whatever was put in or
// taken out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/outline.h"
#include "hlsl/tokens.h"
#include "hlsl/word_numbers.h"

namespace penumbra::preparation {

inline constexpr std::size_t npos = static_cast<std::size_t>(-1);

class ValueTypes;

// A message at a token. The preprocessor keeps no columns: `rank` and `count` say which of the line's tokens
// of that spelling it is (hlsl::column_in); a count of 0, after an edit, that nobody knows.
struct Note : hlsl::Diagnostic {
  std::string spelling{};
  std::size_t rank = 0;
  std::size_t count = 0;
};

class TokenText {
 public:
  // `preprocessed`: no comments, no macros, #line directives for places. Lines before the first #line that
  // names a file are said to be in `main_file`.
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
  bool is_word(std::size_t at) const { return at < tokens_.size() && hlsl::begins_word(leads_[at]); }
  // The first character of a token; '\0' past the last.
  char lead(std::size_t at) const { return at < tokens_.size() ? leads_[at] : '\0'; }
  // Of the word at this index, the same for words spelled alike, below word_numbers();
  // hlsl::WordNumbers::none for other tokens.
  std::uint32_t word_number(std::size_t at) const {
    return at < tokens_.size() ? numbers_[at] : hlsl::WordNumbers::none;
  }
  std::size_t word_numbers() const { return words_.size(); }
  // The bracket that closes the (, [ or { at this index, or opens the one that ends there; npos for other
  // tokens and for brackets without a partner.
  std::size_t partner(std::size_t at) const {
    return at < tokens_.size() && partners_[at] != alone ? partners_[at] : npos;
  }
  std::string spelled(std::size_t first, std::size_t count) const;  // as printed, in one line

  // What stands at file scope (hlsl/outline.h), and what the names in the text stand for (value_types.h).
  // Read once for all passes until one of them edits; the references are good until apply().
  const std::vector<hlsl::Declaration>& outline() const;
  const ValueTypes& types() const;
  // `wanted`, with underscores after it where the text has that word already.
  std::string free_name(std::string wanted) const;

  // Edits; ranges of two edits must not overlap, and several inserts at one place keep their order.
  void replace(std::size_t first, std::size_t count, std::string_view hlsl);
  void insert(std::size_t before, std::string_view hlsl) { replace(before, 0, hlsl); }
  // The same on the line of the token `place`, for text that only moves.
  void insert_from(std::size_t place, std::size_t before, std::string_view hlsl);
  void erase(std::size_t first, std::size_t count) { replace(first, count, {}); }
  void apply();  // all of them at once

  // A message at a token's place.
  void note(std::size_t at, hlsl::Severity severity, std::string message);
  const std::vector<Note>& notes() const { return notes_; }

  std::string file_of(std::size_t at) const;  // main_file where no #line has named one
  std::string print() const;

 private:
  struct Edit {
    std::size_t first;
    std::size_t count;
    std::string text;
    std::size_t place = npos;  // whose line it stands on; npos: that of what it replaces or follows
  };

  void find_partners();
  bool same_line(std::size_t a, std::size_t b) const;
  void append_kept(std::size_t first, std::size_t end);
  void append_made(const Edit& edit);
  std::uint32_t number_of(const hlsl::Token& token);

  std::string text_;
  std::string main_file_;
  std::vector<hlsl::Token> tokens_;
  hlsl::WordNumbers words_;             // of all that stand in the text or once stood there
  std::vector<std::uint32_t> numbers_;  // of every token's word
  std::string leads_;                   // the first character of every token: it answers most questions
  std::vector<hlsl::Token> edited_;     // where apply() writes these three; kept for their room alone
  std::vector<std::uint32_t> edited_numbers_;
  std::string edited_leads_;
  static constexpr std::uint32_t alone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> partners_;
  std::vector<Edit> edits_;
  std::deque<std::string> made_;  // the spellings that edits put in
  std::vector<Note> notes_;
  bool is_edited_ = false;
  // Made when asked for, until apply().
  mutable std::optional<std::vector<hlsl::Declaration>> outline_;
  mutable std::shared_ptr<const ValueTypes> types_;
  mutable std::vector<bool> known_words_;  // by number: whether the word is in the text
};

}  // namespace penumbra::preparation
