#include "project/path_pattern.h"

#include <algorithm>
#include <vector>

namespace penumbra::project {

namespace {

enum class Kind { character, one, run, long_run, folders };

struct Token {
  Kind kind;
  char character = '\0';
};

std::vector<Token> tokens_of(std::string_view pattern) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '?') {
      tokens.push_back({Kind::one});
    } else if (pattern[i] != '*') {
      tokens.push_back({Kind::character, pattern[i]});
    } else if (pattern.substr(i, 2) != "**") {
      tokens.push_back({Kind::run});
    } else {
      const bool at_start = i == 0 || pattern[i - 1] == '/';
      const bool folders = at_start && pattern.substr(i, 3) == "**/";
      tokens.push_back({folders ? Kind::folders : Kind::long_run});
      i += folders ? 2 : 1;
    }
  }
  return tokens;
}

// The pattern positions (NFA states) that the path read so far can have reached; position i is before token
// i.
class Reached {
 public:
  explicit Reached(const std::vector<Token>& tokens) : tokens_(tokens), places_(tokens.size() + 1, false) {
    enter(places_, 0);
  }

  void read(char c) {
    std::vector<bool> next(places_.size(), false);
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (places_[i]) step(i, c, next);
    places_.swap(next);
  }

  bool at_end() const { return places_.back(); }

 private:
  // Tokens that match the empty string are skipped immediately.
  void enter(std::vector<bool>& places, std::size_t i) const {
    for (; !places[i]; ++i) {
      places[i] = true;
      if (i == tokens_.size() || tokens_[i].kind == Kind::character || tokens_[i].kind == Kind::one) return;
    }
  }

  void step(std::size_t i, char c, std::vector<bool>& next) const {
    switch (tokens_[i].kind) {
      case Kind::character:
        if (c == tokens_[i].character) enter(next, i + 1);
        break;
      case Kind::one:
        if (c != '/') enter(next, i + 1);
        break;
      case Kind::run:
        if (c != '/') enter(next, i);
        break;
      case Kind::long_run:
        enter(next, i);
        break;
      case Kind::folders:  // only the end of a folder's name advances
        next[i] = true;
        if (c == '/') enter(next, i + 1);
        break;
    }
  }

  const std::vector<Token>& tokens_;
  std::vector<bool> places_;
};

}  // namespace

bool path_matches(std::string_view pattern, std::string_view path) {
  if (pattern.find('/') == std::string_view::npos) path = path.substr(path.rfind('/') + 1);
  const std::vector<Token> tokens = tokens_of(pattern);
  Reached reached(tokens);
  for (const char c : path) reached.read(c);
  return reached.at_end();
}

}  // namespace penumbra::project
