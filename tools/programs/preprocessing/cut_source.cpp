#include "preprocessing/cut_source.h"

#include <algorithm>
#include <utility>

#include "preprocessing/token.h"
#include "preprocessing/token_scan.h"

namespace penumbra::preprocessing {

namespace {

// The branches of an open condition.
struct Condition {
  std::vector<std::size_t> branches;
  bool otherwise_seen = false;
};

Step step_of(Spelling directive) {
  switch (directive) {
    case known::word_define:
      return Step::define;
    case known::word_undef:
      return Step::undef;
    case known::word_if:
      return Step::on_condition;
    case known::word_ifdef:
      return Step::on_defined;
    case known::word_ifndef:
      return Step::on_undefined;
    case known::word_elif:
      return Step::or_on_condition;
    case known::word_else:
      return Step::otherwise;
    case known::word_endif:
      return Step::end;
    case known::word_include:
      return Step::include;
    default:
      return Step::unusual;
  }
}

// Returns the header that #include names, if nothing follows it on its line.
std::optional<Include> read_header(std::string_view line, Spellings& spellings) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (line.empty() || (line.front() != '"' && line.front() != '<')) return std::nullopt;
  const bool quoted = line.front() == '"';
  const std::size_t end = line.find_first_of(quoted ? "\"\n\\" : ">\n\\", 1);
  if (end == std::string_view::npos || line[end] == '\n' || line[end] == '\\') return std::nullopt;
  TokenScan behind(line.substr(end + 1), spellings);
  const Kind kind = behind.next().kind;
  if ((kind != Kind::newline && kind != Kind::end) || behind.unusual()) return std::nullopt;
  const std::string_view name = line.substr(1, end - 1);
  const bool as_comment = !quoted && (name.find("//") != name.npos || name.find("/*") != name.npos);
  if (as_comment) return std::nullopt;  // glslang's preprocessor treats it so in skipped text
  return Include{std::string(name), quoted};
}

class SourceCut {
 public:
  SourceCut(std::string_view text, Spellings& spellings)
      : spellings_(spellings), scan_(text, spellings), joins_on_(text.ends_with("\\\n")) {}

  CutSource run() {
    for (Token token = scan_.next(); token.kind != Kind::end; token = scan_.next()) {
      if (token.kind == Kind::newline) continue;
      if (token.is(known::hash)) {
        end_run();
        directive();
      } else {
        line_of_text(token);
      }
    }
    end_run();
    // glslang terminates a last line without a newline, and reads its own #line on the next.
    out_.lines = scan_.place().column == 1 ? scan_.line() - 1 : scan_.line();
    out_.usual = !scan_.unusual() && open_.empty() && balanced_ && !joins_on_;
    return out_.usual ? std::move(out_) : CutSource{};
  }

 private:
  void add(const Token& token) {
    out_.tokens.push_back(token);
    out_.places.push_back(scan_.place());
  }

  void line_of_text(Token token) {
    if (!in_run_) begin_run();
    for (; token.kind != Kind::newline && token.kind != Kind::end; token = scan_.next()) {
      if (token.kind == Kind::unusual || token.is(known::hash)) out_.items.back().step = Step::unusual;
      if (token.kind == Kind::identifier) out_.names.push_back(token.spelling);
      add(token);
      print(token);
    }
  }

  void print(const Token& token) {
    const std::size_t here = out_.tokens.size() - 1;
    const Place& place = out_.places[here];
    const bool first = here == out_.runs.back().first;
    const int line = first ? place.line : out_.places[here - 1].line;
    if (line != place.line) {
      out_.printed.append(static_cast<std::size_t>(place.line - line), '\n');
      out_.printed.append(static_cast<std::size_t>(place.column - 1), ' ');
    } else if (!first && blank_between(out_.tokens[here - 1], token)) {
      out_.printed += ' ';
    }
    out_.printed += spellings_.text(token.spelling);
    out_.ends.resize(here);  // a condition's tokens have none
    out_.ends.push_back(out_.printed.size());
  }

  void begin_run() {
    in_run_ = true;
    Item item;
    item.step = Step::run;
    item.index = out_.runs.size();
    out_.items.push_back(item);
    out_.runs.push_back({out_.tokens.size(), 0, out_.names.size(), 0});
  }

  void end_run() {
    if (!std::exchange(in_run_, false)) return;
    out_.items.back().whole_float = scan_.take_whole_float();
    Run& run = out_.runs.back();
    run.last = out_.tokens.size();
    const auto first = out_.names.begin() + static_cast<std::ptrdiff_t>(run.first_name);
    std::sort(first, out_.names.end());
    out_.names.erase(std::unique(first, out_.names.end()), out_.names.end());
    run.last_name = out_.names.size();
  }

  void directive() {
    const Token name = scan_.next();
    if (name.kind == Kind::newline || name.kind == Kind::end) return;
    Item item;
    item.line = scan_.place().line;
    if (name.kind == Kind::identifier) item.step = step_of(name.spelling);
    if (name.is(known::hash)) balanced_ = false;  // in text that glslang skips, "##else" is #else
    const std::string_view rest = scan_.rest();
    const std::vector<Token> line = rest_of_line();
    item.whole_float = scan_.take_whole_float();
    read(item, line, rest);
    nest(item);
    out_.items.push_back(item);
  }

  std::vector<Token> rest_of_line() {
    std::vector<Token> line;
    for (Token token = scan_.next(); token.kind != Kind::newline && token.kind != Kind::end;
         token = scan_.next())
      line.push_back(token);
    return line;
  }

  void read(Item& item, const std::vector<Token>& line, std::string_view rest) {
    switch (item.step) {
      case Step::define:
        return define(item, line);
      case Step::include:
        return include(item, rest);
      case Step::undef:
      case Step::on_defined:
      case Step::on_undefined:
        return named(item, line);
      case Step::on_condition:
      case Step::or_on_condition:
        item.first = out_.tokens.size();
        out_.tokens.insert(out_.tokens.end(), line.begin(), line.end());
        out_.places.resize(out_.tokens.size());
        item.last = out_.tokens.size();
        return;
      case Step::otherwise:
      case Step::end:
        balanced_ = balanced_ && line.empty();  // text behind them is an error in skipped text as well
        return;
      default:
        return;
    }
  }

  void define(Item& item, const std::vector<Token>& line) {
    std::optional<Definition> definition = cut_definition(line);
    item.index = out_.definitions.size();
    if (definition) {
      out_.definitions.push_back(*std::move(definition));
    } else {
      item.step = Step::unusual;
    }
  }

  void include(Item& item, std::string_view rest) {
    std::optional<Include> include = read_header(rest, spellings_);
    item.index = out_.includes.size();
    if (include) {
      out_.includes.push_back(*std::move(include));
    } else {
      item.step = Step::unusual;
    }
  }

  static void named(Item& item, const std::vector<Token>& line) {
    item.malformed = line.size() != 1 || line.front().kind != Kind::identifier;
    if (!item.malformed) item.index = line.front().spelling;
  }

  void nest(const Item& item) {
    const std::size_t here = out_.items.size();
    const Step step = item.step;
    if (step == Step::on_condition || step == Step::on_defined || step == Step::on_undefined) {
      open_.push_back({{here}, false});
      out_.depth = std::max(out_.depth, static_cast<int>(open_.size()));
      return;
    }
    if (step != Step::or_on_condition && step != Step::otherwise && step != Step::end) return;
    if (open_.empty()) {
      balanced_ = false;
      return;
    }
    Condition& condition = open_.back();
    out_.items[condition.branches.back()].next = here;
    balanced_ = balanced_ && (step == Step::end || !condition.otherwise_seen);
    condition.otherwise_seen = condition.otherwise_seen || step == Step::otherwise;
    if (step != Step::end) return condition.branches.push_back(here);
    for (const std::size_t branch : condition.branches) out_.items[branch].end = here;
    open_.pop_back();
  }

  Spellings& spellings_;
  TokenScan scan_;
  CutSource out_;
  std::vector<Condition> open_;
  bool joins_on_;  // up to the text that glslang appends to a file
  bool balanced_ = true;
  bool in_run_ = false;
};

class DefinitionCut {
 public:
  explicit DefinitionCut(const std::vector<Token>& line) : line_(line) {}

  std::optional<Definition> run() {
    if (line_.empty() || line_.front().kind != Kind::identifier ||
        line_.front().spelling == known::word_defined)
      return std::nullopt;
    out_.name = line_.front().spelling;
    at_ = 1;
    if (at_ < line_.size() && !line_[at_].space) {
      if (!line_[at_].is(known::open) || !list()) return std::nullopt;
    }
    body();
    return std::move(out_);
  }

 private:
  bool list() {
    out_.has_list = true;
    ++at_;
    if (at_ < line_.size() && line_[at_].is(known::close)) {
      ++at_;
      return true;
    }
    for (; at_ + 1 < line_.size(); at_ += 2) {
      const Token& name = line_[at_];
      const bool again = std::count(out_.parameters.begin(), out_.parameters.end(), name.spelling) != 0;
      if (name.kind != Kind::identifier || again) return false;
      out_.parameters.push_back(name.spelling);
      if (line_[at_ + 1].is(known::comma)) continue;
      const bool closed = line_[at_ + 1].is(known::close);
      at_ += 2;
      return closed;
    }
    return false;
  }

  void body() {
    for (; at_ < line_.size(); ++at_) {
      Token token = line_[at_];
      const bool doubled = token.is(known::hash) && at_ + 1 < line_.size() &&
                           line_[at_ + 1].is(known::hash) && !line_[at_ + 1].space;
      if (doubled) {
        token.kind = Kind::paste;
        ++at_;
      }
      token.parameter = parameter(token);
      out_.body.push_back(token);
    }
  }

  std::int16_t parameter(const Token& token) const {
    const auto place = std::find(out_.parameters.begin(), out_.parameters.end(), token.spelling);
    if (token.kind != Kind::identifier || place == out_.parameters.end()) return no_parameter;
    return static_cast<std::int16_t>(place - out_.parameters.begin());
  }

  const std::vector<Token>& line_;
  Definition out_;
  std::size_t at_ = 0;
};

}  // namespace

CutSource cut_source(std::string_view text, Spellings& spellings) {
  return SourceCut(text, spellings).run();
}

std::optional<Definition> cut_definition(const std::vector<Token>& line) {
  return DefinitionCut(line).run();
}

bool are_identical(const Definition& a, const Definition& b) {
  if (a.has_list != b.has_list || a.parameters != b.parameters || a.body.size() != b.body.size())
    return false;
  for (std::size_t i = 0; i < a.body.size(); ++i) {
    const Token& one = a.body[i];
    const Token& other = b.body[i];
    if (one.kind != other.kind || one.spelling != other.spelling) return false;
    if (i > 0 && one.space != other.space) return false;
  }
  return true;
}

}  // namespace penumbra::preprocessing
