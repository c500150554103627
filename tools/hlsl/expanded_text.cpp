#include "hlsl/expanded_text.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace penumbra::hlsl {

namespace {

constexpr std::string_view blanks = " \t";

// #line N "file"
bool take_line_directive(const std::string& text, CodeLine& place) {
  if (text.compare(0, 6, "#line ") != 0) return false;
  place.line = std::atoi(text.c_str() + 6);
  const std::size_t open = text.find('"');
  const std::size_t close = text.rfind('"');
  if (open != std::string::npos && close > open) place.file = text.substr(open + 1, close - open - 1);
  return true;
}

char closer_of(char opener) {
  switch (opener) {
    case '(':
      return ')';
    case '[':
      return ']';
    default:
      return '}';
  }
}

struct Bracket {
  char character;
  const CodeLine* line;
};

OpenPlace place_of(const Bracket& bracket, const std::string& rest) {
  const std::string token(1, bracket.character);
  return {bracket.line->file, bracket.line->line, 0, token, "'" + token + "' " + rest};
}

// The words of a preprocessor line after '#', or empty; comments and continuation lines are skipped.
class DirectiveReader {
 public:
  std::string directive(std::string_view line) {
    const bool continues = continued_;
    continued_ = !line.empty() && line.back() == '\\';
    const std::string code = without_comments(line);
    const std::size_t hash = code.find_first_not_of(blanks);
    if (continues || hash == std::string::npos || code[hash] != '#') return {};
    const std::size_t start = code.find_first_not_of(blanks, hash + 1);
    if (start == std::string::npos) return {};
    return code.substr(start, code.find_first_of(" \t(!", start) - start);
  }

 private:
  std::string without_comments(std::string_view line) {
    std::string code;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string_view two = line.substr(i, 2);
      if (in_comment_) {
        if (two == "*/") in_comment_ = false, ++i;
      } else if (two == "//") {
        break;
      } else if (two == "/*") {
        in_comment_ = true, ++i;
      } else {
        code += line[i];
      }
    }
    return code;
  }

  bool in_comment_ = false;
  bool continued_ = false;
};

std::optional<OpenPlace> open_condition_in(const std::string& file, const std::string& text) {
  std::vector<OpenPlace> open;
  DirectiveReader reader;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string word = reader.directive(line);
    const int column = static_cast<int>(line.find('#')) + 1;
    if (word == "if" || word == "ifdef" || word == "ifndef") {
      open.push_back({file, number, column, "#" + word, "'#" + word + "' has no '#endif' in this file"});
    } else if (word == "endif" || word == "else" || word == "elif") {
      if (open.empty())
        return OpenPlace{file, number, column, "#" + word, "'#" + word + "' has no '#if' in this file"};
      if (word == "endif") open.pop_back();
    }
  }
  return open.empty() ? std::nullopt : std::optional<OpenPlace>(open.back());
}

}  // namespace

std::vector<CodeLine> expanded_lines(const std::string& preprocessed) {
  std::vector<CodeLine> lines;
  std::istringstream stream(preprocessed);
  CodeLine place{{}, 1, {}};
  for (std::string text; std::getline(stream, text);) {
    if (take_line_directive(text, place)) continue;
    lines.push_back({place.file, place.line, text});
    ++place.line;
  }
  return lines;
}

std::optional<OpenPlace> unbalanced_bracket(const std::vector<CodeLine>& lines) {
  std::vector<Bracket> open;
  for (const CodeLine& line : lines) {
    for (const char character : line.text) {
      const Bracket bracket{character, &line};
      if (character == '(' || character == '[' || character == '{') {
        open.push_back(bracket);
      } else if (character == ')' || character == ']' || character == '}') {
        if (open.empty()) return place_of(bracket, "closes nothing");
        if (closer_of(open.back().character) != character) return place_of(open.back(), "is never closed");
        open.pop_back();
      }
    }
  }
  return open.empty() ? std::nullopt : std::optional<OpenPlace>(place_of(open.back(), "is never closed"));
}

std::optional<OpenPlace> open_condition(const SourceFiles& sources) {
  for (const std::string& name : sources.names())
    if (std::optional<OpenPlace> open = open_condition_in(name, sources.text(name))) return open;
  return std::nullopt;
}

std::optional<CodeLine> unfinished_line_before(const std::vector<CodeLine>& lines, const std::string& file,
                                               int line) {
  auto at = std::find_if(lines.begin(), lines.end(),
                         [&](const CodeLine& code) { return code.file == file && code.line == line; });
  while (at != lines.begin() && at != lines.end()) {
    --at;
    const std::size_t last = at->text.find_last_not_of(blanks);
    if (last == std::string::npos) continue;
    const bool finished = std::string_view(";{}(),:").find(at->text[last]) != std::string_view::npos;
    return finished && at->text[last] != '}' && at->text[last] != ')' ? std::nullopt : std::optional(*at);
  }
  return std::nullopt;
}

int column_after_code(std::string_view line) {
  const std::string_view code = line.substr(0, line.find("//"));
  const std::size_t last = code.find_last_not_of(blanks);
  return last == std::string_view::npos ? 1 : static_cast<int>(last) + 2;
}

}  // namespace penumbra::hlsl
