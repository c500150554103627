#include "preprocessing/output.h"

#include <utility>

#include "preprocessing/printing.h"

namespace penumbra::preprocessing {

// Returns true if it begins a line.
bool Output::sync_to(int line) {
  const bool begins = line_ < line;
  for (; line_ < line; ++line_)
    if (line_ > 0) text_ += '\n';
  return begins;
}

void Output::begin(const Token& token, int line, int column) {
  if (sync_to(line)) {
    if (column < 1) throw Unusual("a token without a known column");
    text_.append(static_cast<std::size_t>(column - 1), ' ');
  } else if (blank_between(before_, token)) {
    text_ += ' ';
  }
}

void Output::token(const Token& token, int line, int column) {
  begin(token, line, column);
  text_ += spellings_.text(token.spelling);
  before_ = token;
}

void Output::copy(const CutSource& source, std::size_t first, std::size_t last) {
  if (first == last) return;
  const Place& place = source.places[first];
  token(source.tokens[first], place.line, place.column);
  text_.append(source.printed, source.ends[first], source.ends[last - 1] - source.ends[first]);
  line_ = source.places[last - 1].line;
  before_ = source.tokens[last - 1];
}

void Output::line_directive(int line, int next, const std::string& file) {
  sync_to(line);
  text_.append("#line ").append(std::to_string(next)).append(" \"").append(file).append("\"\n");
  line_ = next;
}

std::string Output::take() {
  text_ += '\n';
  return std::exchange(text_, {});
}

}  // namespace penumbra::preprocessing
