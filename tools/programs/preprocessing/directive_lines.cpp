#include "preprocessing/directive_lines.h"

#include "preprocessing/token_scan.h"

namespace penumbra::preprocessing {

namespace {

class DirectiveScan {
 public:
  explicit DirectiveScan(std::string_view text) : text_(text), scan_(text, spellings_) {}

  std::vector<DirectiveLine> run() {
    bool begins_line = true;
    for (next(); token_.kind != Kind::end; next()) {
      if (begins_line && token_.is(known::hash)) directive();
      begins_line = token_.kind == Kind::newline;
    }
    return std::move(lines_);
  }

 private:
  void next() {
    token_ = scan_.next();
    end_ = text_.size() - scan_.rest().size();
  }

  bool in_line() const { return token_.kind != Kind::newline && token_.kind != Kind::end; }

  // The word that begins at the token.
  Word word() const {
    return {{}, scan_.place().line, scan_.place().column, end_ - spellings_.text(token_.spelling).size()};
  }

  void directive() {
    DirectiveLine line;
    const Word hash = word();
    line.line = hash.line;
    line.column = hash.column;
    line.offset = hash.offset;
    line.end = {{}, hash.line, hash.column + 1, hash.offset + 1};
    next();
    if (token_.kind == Kind::identifier) {
      line.name = spellings_.text(token_.spelling);
      line.end = behind(word());
      next();
    }
    for (; in_line(); next()) {
      if (token_.space || line.words.empty()) line.words.push_back(word());
      line.words.back().text += spellings_.text(token_.spelling);
      line.end = behind(word());
    }
    for (const Word& word : line.words) line.rest.append(line.rest.empty() ? "" : " ").append(word.text);
    const std::size_t newline = text_.find('\n', line.end.offset);
    line.line_comment = text_.substr(line.end.offset, newline - line.end.offset).find("//") != text_.npos;
    lines_.push_back(std::move(line));
  }

  Word behind(const Word& begin) const {
    const std::size_t length = spellings_.text(token_.spelling).size();
    return {{}, begin.line, begin.column + static_cast<int>(length), begin.offset + length};
  }

  std::string_view text_;
  Spellings spellings_;
  TokenScan scan_;
  Token token_;
  std::size_t end_ = 0;  // offset behind the token
  std::vector<DirectiveLine> lines_;
};

}  // namespace

std::vector<DirectiveLine> directive_lines(std::string_view text) {
  return DirectiveScan(text).run();
}

}  // namespace penumbra::preprocessing
