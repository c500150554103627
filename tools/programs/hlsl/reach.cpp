#include "hlsl/reach.h"

#include <algorithm>
#include <utility>

#include "hlsl/declarations.h"
#include "hlsl/string_interner.h"
#include "platform/content_hash.h"

namespace penumbra::hlsl {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

bool is_static_constant(const std::vector<Token>& tokens, const Declaration& declaration) {
  bool is_static = false;
  bool is_constant = false;
  for (std::size_t at = declaration.type; at < declaration.name; ++at) {
    is_static = is_static || tokens[at].spelling == "static";
    is_constant = is_constant || tokens[at].spelling == "const";
  }
  return is_static && is_constant;
}

// `a, b` declares two: uses are not distinguished.
bool declares_several(const std::vector<Token>& tokens, const Declaration& declaration) {
  int depth = 0;
  for (std::size_t at = declaration.first; at <= declaration.last; ++at) {
    if (tokens[at].kind != Token::Kind::punctuation) continue;
    const char mark = tokens[at].spelling[0];
    if (mark == '(' || mark == '[' || mark == '{') ++depth;
    if (mark == ')' || mark == ']' || mark == '}') --depth;
    if (mark == ',' && depth == 0) return true;
  }
  return false;
}

bool may_go(const std::vector<Token>& tokens, const Declaration& declaration) {
  using Kind = Declaration::Kind;
  if (declaration.name == Declaration::none) return false;
  if (declaration.kind == Kind::function || declaration.kind == Kind::prototype) return true;
  return declaration.kind == Kind::variable && is_static_constant(tokens, declaration) &&
         !declares_several(tokens, declaration);
}

// The tokens that may follow a declared name.
bool ends_declarator(const Token& token) {
  return token.kind == Token::Kind::punctuation &&
         std::string_view(";,[:=").find(token.spelling[0]) != std::string_view::npos;
}

// Keeps the newlines and #line directives of removed text.
void append_lines_alone(const std::string& text, std::size_t begin, std::size_t end, std::string& out) {
  for (std::size_t newline = text.find('\n', begin); newline < end; newline = text.find('\n', newline + 1)) {
    out += '\n';
    const std::size_t next = text.find_first_not_of(" \t", newline + 1);
    if (next >= end || text[next] != '#') continue;
    const std::size_t line_end = std::min(text.find('\n', next), end);
    out.append(text, next, line_end - next);
  }
}

}  // namespace

// A single pass over the declarations in order.
class ReachReader {
 public:
  explicit ReachReader(Reach& to)
      : to_(to), tokens_(to.tokens_), declarations_(read_declarations(to.tokens_)) {}

  // Returns the names that occur outside of all removable declarations.
  std::vector<std::size_t> run(std::string_view entry) {
    number_names();
    std::size_t at = 0;
    for (const Declaration& declaration : declarations_) {
      take_roots(at, declaration.first);
      read(declaration);
      at = declaration.last + 1;
    }
    take_roots(at, tokens_.size());
    word(entry, nullptr, roots_);
    for (std::size_t name = 0; name < keys_.size(); ++name) {
      hash_.reset();
      for (const std::string& key : keys_[name]) hash_.update(key);
      to_.names_[name].key = hash_.hex();
    }
    return std::move(roots_);
  }

 private:
  struct Word {
    std::size_t name = none;  // index into names_ of a removable one
    std::string meaning;      // the keys of its declarations so far; empty without any
  };

  std::string_view spelling(std::size_t token) const { return tokens_[token].spelling; }

  void number_names() {
    for (const Declaration& declaration : declarations_) {
      if (!may_go(tokens_, declaration)) continue;
      Word& word = word_of(spelling(declaration.name));
      if (word.name != none) continue;
      word.name = to_.names_.size();
      to_.names_.emplace_back();
      keys_.emplace_back();
    }
  }

  Word& word_of(std::string_view spelled) {
    const std::uint32_t number = numbers_.add(spelled);
    if (number == words_.size()) words_.emplace_back();
    return words_[number];
  }

  // A name that is used: its meaning is added to the hash, the declarations that it reaches to the list.
  void word(std::string_view spelled, platform::ContentHash* hash, std::vector<std::size_t>& reached) {
    const std::uint32_t number = numbers_.find(spelled);
    if (number == StringInterner::none) return;
    const Word& known = words_[number];
    if (known.name != none) reached.push_back(known.name);
    if (hash != nullptr && !known.meaning.empty()) hash->update(known.meaning);
  }

  void token(const Token& token, platform::ContentHash* hash, std::vector<std::size_t>& reached) {
    if (token.kind == Token::Kind::identifier) word(token.spelling, hash, reached);
    if (token.kind != Token::Kind::string) return;
    std::string quoted(token.spelling);  // [patchconstantfunc("Name")]
    std::replace(quoted.begin(), quoted.end(), '"', ' ');
    for (const Token& inside : lex(quoted))
      if (inside.kind == Token::Kind::identifier) word(inside.spelling, hash, reached);
  }

  void take_roots(std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) token(tokens_[at], nullptr, roots_);
  }

  void read(const Declaration& declaration) {
    const Token& first = tokens_[declaration.first];
    const Token& last = tokens_[declaration.last];
    const char* const begin = first.spelling.data();
    const char* const end = last.spelling.data() + last.spelling.size();
    hash_.reset();
    hash_.update(declaration.scope).update(first.file).update(first.line).update(last.line);
    hash_.update(std::string_view(begin, static_cast<std::size_t>(end - begin)));
    const bool goes = may_go(tokens_, declaration);
    const std::size_t name = goes ? word_of(spelling(declaration.name)).name : none;
    std::vector<std::size_t>& reached = goes ? to_.names_[name].spelled : roots_;
    for (std::size_t at = declaration.first; at <= declaration.last; ++at)
      if (!goes || at != declaration.name) token(tokens_[at], &hash_, reached);
    const std::string key = hash_.hex();
    if (goes) {
      to_.names_[name].declarations.push_back({declaration.first, declaration.last});
      keys_[name].push_back(key);
    }
    declare(declaration, goes, key);
  }

  void declare(const Declaration& declaration, bool goes, const std::string& key) {
    using Kind = Declaration::Kind;
    const bool by_name = goes || declaration.kind == Kind::structure;
    if (by_name && declaration.name != Declaration::none) add_meaning(spelling(declaration.name), key);
    if (goes) return;
    // The members of a buffer, the variables of a list, those that follow a struct.
    for (std::size_t at = declaration.first; at < declaration.last; ++at)
      if (tokens_[at].kind == Token::Kind::identifier &&
          (ends_declarator(tokens_[at + 1]) || declaration.kind == Kind::other))
        add_meaning(spelling(at), key);
  }

  void add_meaning(std::string_view spelled, const std::string& key) {
    std::string& meaning = word_of(spelled).meaning;
    if (meaning.empty()) {
      meaning = key;
    } else if (meaning != key) {
      hash_.reset();
      meaning = hash_.update(meaning).update(key).hex();
    }
  }

  Reach& to_;
  const std::vector<Token>& tokens_;
  std::vector<Declaration> declarations_;
  StringInterner numbers_;   // numbers of all declared names
  std::vector<Word> words_;  // indexed by these numbers
  platform::ContentHash hash_;
  std::vector<std::vector<std::string>> keys_;  // for each of names_: the keys of its declarations
  std::vector<std::size_t> roots_;
};

Reach::Reach(const std::string& expanded, std::string main_file, std::string_view entry)
    : text_(expanded), main_file_(std::move(main_file)), tokens_(lex(text_)) {
  for (Token& token : tokens_)
    if (token.file.empty()) token.file = main_file_;
  std::vector<std::size_t> roots = ReachReader(*this).run(entry);
  reached_.assign(names_.size(), false);
  reach(std::move(roots), reached_);
  for (std::size_t name = 0; name < names_.size(); ++name) {
    if (reached_[name]) continue;
    unreached_names_.push_back(name);
    unreached_.push_back(names_[name].key);
  }
}

void Reach::reach(std::vector<std::size_t> from, std::vector<bool>& reached) const {
  while (!from.empty()) {
    const std::size_t name = from.back();
    from.pop_back();
    if (reached[name]) continue;
    reached[name] = true;
    from.insert(from.end(), names_[name].spelled.begin(), names_[name].spelled.end());
  }
}

std::vector<std::size_t> Reach::at(const Diagnostic& message) const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < unreached_names_.size(); ++i) {
    const std::vector<Range>& declarations = names_[unreached_names_[i]].declarations;
    if (std::any_of(declarations.begin(), declarations.end(), [&](const Range& range) {
          return tokens_[range.first].file == message.file && tokens_[range.first].line <= message.line &&
                 message.line <= tokens_[range.last].line;
        }))
      found.push_back(i);
  }
  return found;
}

std::size_t Reach::offset(std::size_t token) const {
  return static_cast<std::size_t>(tokens_[token].spelling.data() - text_.data());
}

std::string Reach::text_with(const std::vector<std::size_t>& also) const {
  std::vector<bool> stays = reached_;
  std::vector<std::size_t> from;
  from.reserve(also.size());
  for (const std::size_t i : also) from.push_back(unreached_names_[i]);
  reach(std::move(from), stays);
  std::vector<Range> gone;
  for (std::size_t name = 0; name < names_.size(); ++name)
    if (!stays[name])
      gone.insert(gone.end(), names_[name].declarations.begin(), names_[name].declarations.end());
  std::sort(gone.begin(), gone.end(), [](const Range& a, const Range& b) { return a.first < b.first; });

  std::string out;
  out.reserve(text_.size());
  std::size_t at = 0;
  for (const Range& range : gone) {
    const std::size_t begin = offset(range.first);
    const std::size_t end = offset(range.last) + tokens_[range.last].spelling.size();
    out.append(text_, at, begin - at);
    append_lines_alone(text_, begin, end, out);
    at = end;
  }
  return out.append(text_, at);
}

}  // namespace penumbra::hlsl
