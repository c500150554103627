#include "shaderlab/code_block.h"

#include <algorithm>

#include "shaderlab/characters.h"

namespace penumbra::shaderlab {

namespace {

constexpr Language all_languages[] = {Language::hlsl, Language::cg, Language::glsl};

std::optional<Language> closing_word(std::string_view word) {
  if (word.size() < 5 || !same_keyword(word.substr(0, 3), "END")) return std::nullopt;
  for (const Language language : all_languages)
    if (same_keyword(word.substr(3), language_name(language))) return language;
  return std::nullopt;
}

std::string opening_word(const CodeBlock& block) {
  return std::string(language_name(block.language)) + (block.is_include ? "INCLUDE" : "PROGRAM");
}

std::string closing_word_of(Language language) {
  return std::string("END") + language_name(language);
}

class BlockScan {
 public:
  BlockScan(std::string_view text, const CodeBlock& block) : text_(text), block_(block), at_(block.begin) {}

  BlockEnd run() {
    while (at_.offset < text_.size() && !done_) step();
    if (!done_) result_ = unterminated();
    return result_;
  }

 private:
  bool starts(std::string_view with) const { return text_.substr(at_.offset, with.size()) == with; }

  void advance() {
    if (text_[at_.offset++] == '\n') {
      ++at_.line;
      at_.column = 1;
    } else {
      ++at_.column;
    }
  }

  void step() {
    const char c = text_[at_.offset];
    if (starts("//")) {
      comment("\n");
    } else if (starts("/*")) {
      comment("*/");
    } else if (c == '"') {
      string();
    } else if (is_identifier_character(c)) {
      word(false);
    } else {
      advance();
    }
  }

  void comment(std::string_view closer) {
    advance();
    advance();
    while (at_.offset < text_.size()) {
      if (starts(closer)) {
        for (std::size_t i = 0; i < closer.size(); ++i) advance();
        return;
      }
      if (is_identifier_character(text_[at_.offset])) {
        word(true);
      } else {
        advance();
      }
    }
  }

  void string() {
    advance();
    while (at_.offset < text_.size() && text_[at_.offset] != '"' && text_[at_.offset] != '\n') advance();
    if (at_.offset < text_.size()) advance();
  }

  void word(bool in_comment) {
    const Place begin = at_;
    while (at_.offset < text_.size() && is_identifier_character(text_[at_.offset])) advance();
    const std::string_view spelling = text_.substr(begin.offset, at_.offset - begin.offset);
    const std::optional<Language> closes = closing_word(spelling);
    if (in_comment) {
      if (closes == block_.language && commented_end_.line == 0) commented_end_ = begin;
    } else if (closes) {
      close(begin, *closes);
    } else if (block_keyword(spelling)) {
      done_ = true;
      result_.problem = "the " + opening_word(block_) + " of line " + std::to_string(block_.keyword.line) +
                        " is not closed before this " + upper(spelling) + ": write " +
                        closing_word_of(block_.language) + " first";
      result_.problem_place = begin;
    }
  }

  void close(const Place& place, Language closes) {
    done_ = true;
    if (closes == block_.language) {
      result_.end = place;
      result_.after = at_.offset;
      return;
    }
    result_.problem = closing_word_of(closes) + " does not close the " + opening_word(block_) + " of line " +
                      std::to_string(block_.keyword.line) + ": write " + closing_word_of(block_.language);
    result_.problem_place = place;
  }

  BlockEnd unterminated() const {
    BlockEnd none;
    none.problem =
        opening_word(block_) + " is not closed: no " + closing_word_of(block_.language) + " follows";
    if (commented_end_.line > 0)
      none.problem += " (the one in line " + std::to_string(commented_end_.line) + " is inside a comment)";
    none.problem_place = block_.keyword;
    return none;
  }

  std::string_view text_;
  const CodeBlock& block_;
  Place at_;
  bool done_ = false;
  Place commented_end_;
  BlockEnd result_;
};

}  // namespace

std::optional<BlockKeyword> block_keyword(std::string_view word) {
  for (const Language language : all_languages) {
    const std::string_view name = language_name(language);
    if (word.size() != name.size() + 7 || !same_keyword(word.substr(0, name.size()), name)) continue;
    const std::string_view rest = word.substr(name.size());
    if (same_keyword(rest, "PROGRAM")) return BlockKeyword{language, false};
    if (same_keyword(rest, "INCLUDE")) return BlockKeyword{language, true};
  }
  return std::nullopt;
}

BlockEnd find_block_end(std::string_view text, const CodeBlock& block) {
  return BlockScan(text, block).run();
}

}  // namespace penumbra::shaderlab
