#include "hlsl/expanded_text.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "hlsl/token_place.h"
#include "hlsl/tokens.h"

namespace penumbra::hlsl {

namespace {

constexpr std::string_view blanks = " \t";

// The directive is #line N "file".
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
  std::size_t offset;  // position in its line
};

OpenPlace place_of(const Bracket& bracket, const std::string& rest, const SourceFiles& sources) {
  const std::string token(1, bracket.character);
  const std::string& text = bracket.line->text;
  const auto here = text.begin() + static_cast<std::ptrdiff_t>(bracket.offset);
  const auto rank = static_cast<std::size_t>(std::count(text.begin(), here, bracket.character));
  const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), bracket.character));
  const std::string source_line = sources.line(bracket.line->file, bracket.line->line);
  return {bracket.line->file, bracket.line->line, column_in(source_line, token, rank, count), token,
          "'" + token + "' " + rest};
}

// The place at which the code of a source line starts, in constant time for each requested line.
class Indentation {
 public:
  explicit Indentation(const SourceFiles& sources) : sources_(sources) {}

  std::string_view code(const CodeLine& place) {
    const std::vector<std::string_view>& lines = lines_of(place.file);
    if (place.line < 1 || static_cast<std::size_t>(place.line) > lines.size()) return {};
    const std::string_view line = lines[static_cast<std::size_t>(place.line) - 1];
    return line.substr(std::min(line.find_first_not_of(blanks), line.size()));
  }

  std::size_t of(const CodeLine& place) {
    const std::string_view rest = code(place);
    if (rest.empty()) return 0;
    return static_cast<std::size_t>(rest.data() -
                                    lines_of(place.file)[static_cast<std::size_t>(place.line) - 1].data());
  }

 private:
  const std::vector<std::string_view>& lines_of(const std::string& file) {
    const auto [at, is_new] = files_.try_emplace(file);
    if (is_new && sources_.contains(file)) {
      const std::string_view text = sources_.text(file);
      for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        at->second.push_back(text.substr(start, end - start));
        start = end + 1;
      }
    }
    return at->second;
  }

  const SourceFiles& sources_;
  std::map<std::string, std::vector<std::string_view>> files_;
};

// Pairs brackets in their order, until one has no match.
class BracketPairs {
 public:
  explicit BracketPairs(const SourceFiles& sources) : sources_(sources), indentation_(sources) {}

  // Returns false if it is unmatched, or does not match the innermost open bracket; fault() then returns it.
  bool take(const Bracket& bracket) {
    const char c = bracket.character;
    if (c == '(' || c == '[' || c == '{') {
      open_.push_back(bracket);
      return true;
    }
    const auto match = std::find_if(open_.rbegin(), open_.rend(),
                                    [&](const Bracket& opener) { return closer_of(opener.character) == c; });
    const bool lost = match == open_.rend();
    if (lost && (open_.empty() || open_.back().line != bracket.line)) {
      fault_ = place_of(bracket, "closes nothing", sources_);
    } else if (lost || match != open_.rbegin()) {
      fault_ = place_of(open_.back(), "is never closed", sources_);
    } else {
      close(bracket);
    }
    return !fault_;
  }

  std::optional<OpenPlace> fault() const {
    if (fault_ || open_.empty()) return fault_;
    const bool suspected = suspect_ && suspect_depth_ > open_.size();
    return place_of(suspected ? *suspect_ : open_.back(), "is never closed", sources_);
  }

 private:
  void close(const Bracket& closer) {
    const Bracket opener = open_.back();
    // The indentation is that of the source: expanded text may have lost its own.
    if (!suspect_ && closer.character == '}' && indentation_.code(*closer.line).starts_with('}') &&
        indentation_.of(*closer.line) < indentation_.of(*opener.line)) {
      suspect_ = opener;
      suspect_depth_ = open_.size();
    }
    open_.pop_back();
    if (open_.empty()) suspect_.reset();  // balanced so far: no candidate needed
  }

  const SourceFiles& sources_;
  Indentation indentation_;
  std::vector<Bracket> open_;
  std::optional<Bracket> suspect_;
  std::size_t suspect_depth_ = 0;
  std::optional<OpenPlace> fault_;
};

// Moves from `at`, the current location of the text, to that of the next code.
void go_to(const LinePlace& place, LinePlace& at, std::string& out) {
  const bool near =
      at.file == place.file && at.line <= place.line && place.line - at.line <= most_empty_lines;
  if (near) {
    out.append(static_cast<std::size_t>(place.line - at.line), '\n');
  } else {
    out.append("#line ").append(std::to_string(place.line));
    if (!place.file.empty() || !at.file.empty()) out.append(" \"").append(place.file).append("\"");
    out.push_back('\n');
  }
  at = place;
}

}  // namespace

std::vector<CodeLine> expanded_lines(const std::string& preprocessed, const std::string& main_file) {
  std::vector<CodeLine> lines;
  std::istringstream stream(preprocessed);
  CodeLine place{main_file, 1, {}};
  for (std::string text; std::getline(stream, text);) {
    if (take_line_directive(text, place)) continue;
    lines.push_back({place.file, place.line, text});
    ++place.line;
  }
  return lines;
}

std::optional<OpenPlace> unbalanced_bracket(const std::vector<CodeLine>& lines, const SourceFiles& sources) {
  BracketPairs pairs(sources);
  constexpr std::string_view brackets = "()[]{}";
  for (const CodeLine& line : lines)
    for (std::size_t at = line.text.find_first_of(brackets); at != std::string::npos;
         at = line.text.find_first_of(brackets, at + 1))
      if (!pairs.take({line.text[at], &line, at})) return pairs.fault();
  return pairs.fault();
}

std::string dense_lines(std::string_view preprocessed) {
  std::string out;
  out.reserve(preprocessed.size());
  LinePlace next;
  LinePlace at;
  for (std::size_t begin = 0; begin < preprocessed.size();) {
    const std::size_t end = std::min(preprocessed.find('\n', begin), preprocessed.size());
    const std::string_view line = preprocessed.substr(begin, end - begin);
    begin = end + 1;
    if (take_line_directive(line, next)) continue;
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) {
      go_to(next, at, out);
      out.append(line).push_back('\n');
      ++at.line;
    }
    ++next.line;
  }
  return out;
}

}  // namespace penumbra::hlsl
