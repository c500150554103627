#include "preprocessing/cut_source.h"

#include <algorithm>
#include <utility>

#include "preprocessing/token_scan.h"

namespace penumbra::preprocessing {

namespace {

// The branches of an open condition.
struct OpenCondition {
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
    case known::word_include_with_pragmas:
      return Step::include;
    case known::word_pragma:
    case known::word_warning:
    case known::word_line_directive:
      return Step::skipped;
    default:
      return Step::problem;
  }
}

std::string_view first_line(std::string_view text) {
  text = text.substr(0, text.find('\n'));
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(first);
}

// Parses the text that follows #define. Throws Problem.
class DefinitionCut {
 public:
  DefinitionCut(const std::vector<Token>& line, const Spellings& spellings)
      : line_(line), spellings_(spellings) {}

  Definition run() {
    if (line_.empty() || line_.front().kind != Kind::identifier) throw Problem("'#define' names no macro");
    if (line_.front().spelling == known::word_defined)
      throw Problem("'defined' cannot be the name of a macro");
    out_.name = line_.front().spelling;
    at_ = 1;
    if (at_ < line_.size() && !line_[at_].space && line_[at_].is(known::open)) list();
    body();
    return std::move(out_);
  }

 private:
  void list() {
    out_.has_list = true;
    ++at_;
    if (at_ < line_.size() && line_[at_].is(known::close)) {
      ++at_;
      return;
    }
    for (; at_ + 1 < line_.size(); at_ += 2) {
      const Token& name = line_[at_];
      if (spellings_.text(name.spelling) == ".")
        throw Problem(
            "not supported here: macros with '...'; name the parameters, and write a macro for each "
            "number of arguments");
      if (name.kind != Kind::identifier) break;
      if (parameter(name) != no_parameter)
        throw Problem("two parameters of this macro are called '" + spellings_.text(name.spelling) + "'");
      out_.parameters.push_back(name.spelling);
      if (line_[at_ + 1].is(known::comma)) continue;
      at_ += 2;
      if (line_[at_ - 1].is(known::close)) return;
      break;
    }
    throw Problem("the parameters of macro '" + spellings_.text(out_.name) + "' are not closed by ')'");
  }

  void body() {
    for (; at_ < line_.size(); ++at_) {
      Token token = line_[at_];
      const bool doubled = token.is(known::hash) && at_ + 1 < line_.size() &&
                           line_[at_ + 1].is(known::hash) && !line_[at_ + 1].space;
      if (doubled) {
        token.kind = Kind::paste;
        out_.pastes = true;
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
  const Spellings& spellings_;
  Definition out_;
  std::size_t at_ = 0;
};

class SourceCut {
 public:
  SourceCut(std::string_view text, Spellings& spellings) : spellings_(spellings), scan_(text, spellings) {}

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
    if (scan_.open_comment().line > 0) fail("'/*' is never closed", scan_.open_comment());
    if (!open_.empty()) {
      const Item& item = out_.items[open_.back().branches.front()];
      fail("'#" + word_of(item.step) + "' has no '#endif' in this file", item.place);
    }
    return std::move(out_);
  }

 private:
  // Only the first is kept.
  void fail(const std::string& problem, const Place& place) {
    if (!out_.problem.empty()) return;
    out_.problem = problem;
    out_.problem_place = place;
  }

  static std::string word_of(Step step) {
    return step == Step::on_condition      ? "if"
           : step == Step::on_defined      ? "ifdef"
           : step == Step::on_undefined    ? "ifndef"
           : step == Step::or_on_condition ? "elif"
           : step == Step::otherwise       ? "else"
                                           : "endif";
  }

  void add(const Token& token, const Place& place) {
    out_.tokens.push_back(token);
    out_.places.push_back(place);
  }

  void line_of_text(Token token) {
    if (!in_run_) begin_run();
    for (; token.kind != Kind::newline && token.kind != Kind::end; token = scan_.next()) {
      Run& run = out_.runs.back();
      const bool bad = token.kind == Kind::bad || token.is(known::hash);
      if (bad && run.bad == none) run.bad = out_.tokens.size();
      if (token.kind == Kind::identifier) out_.names.push_back(token.spelling);
      add(token, scan_.place());
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
    out_.runs.push_back({out_.tokens.size(), 0, out_.names.size(), 0, none});
  }

  void end_run() {
    if (!std::exchange(in_run_, false)) return;
    Run& run = out_.runs.back();
    run.last = out_.tokens.size();
    run.bad = std::min(run.bad, run.last);
    const auto first = out_.names.begin() + static_cast<std::ptrdiff_t>(run.first_name);
    std::sort(first, out_.names.end());
    out_.names.erase(std::unique(first, out_.names.end()), out_.names.end());
    run.last_name = out_.names.size();
  }

  void directive() {
    Item item;
    item.place = scan_.place();
    const Token name = scan_.next();
    if (name.kind == Kind::newline || name.kind == Kind::end) return;
    if (name.kind == Kind::identifier) item.step = step_of(name.spelling);
    const std::string_view rest = scan_.rest();
    std::vector<Token> line;
    std::vector<Place> places;
    for (Token token = scan_.next(); token.kind != Kind::newline && token.kind != Kind::end;
         token = scan_.next()) {
      line.push_back(token);
      places.push_back(scan_.place());
    }
    try {
      if (name.is(known::hash)) throw Problem("unexpected token '#'");
      read(item, name, line, places, rest);
    } catch (const Problem& problem) {
      item.index = out_.messages.size();
      item.step = Step::problem;
      out_.messages.emplace_back(problem.what());
    }
    nest(item);
    out_.items.push_back(item);
  }

  void read(Item& item, const Token& name, const std::vector<Token>& line, const std::vector<Place>& places,
            std::string_view rest) {
    const std::string& word = spellings_.text(name.spelling);
    switch (item.step) {
      case Step::define: {
        Definition definition = DefinitionCut(line, spellings_).run();
        definition.place = places.front();
        item.index = out_.definitions.size();
        out_.definitions.push_back(std::move(definition));
        return;
      }
      case Step::include:
        item.index = out_.includes.size();
        out_.includes.push_back(header(line, first_line(rest)));
        return;
      case Step::undef:
      case Step::on_defined:
      case Step::on_undefined:
        item.index =
            line.size() == 1 && line.front().kind == Kind::identifier ? line.front().spelling : known::open;
        if (item.index == known::open && item.step == Step::undef)
          throw Problem("'#undef' takes the name of one macro");
        return;
      case Step::on_condition:
      case Step::or_on_condition:
        item.first = out_.tokens.size();
        for (std::size_t i = 0; i < line.size(); ++i) add(line[i], places[i]);
        item.last = out_.tokens.size();
        return;
      case Step::skipped:
        item.once = name.spelling == known::word_pragma && !line.empty() &&
                    spellings_.text(line.front().spelling) == "once";
        return;
      case Step::otherwise:
      case Step::end:
        return;
      default:
        break;
    }
    if (name.spelling != known::word_error) throw Problem("unknown directive '#" + word + "'");
    const std::string_view said = first_line(rest);
    throw Problem(said.empty() ? "'#error'" : "'#error': " + std::string(said));
  }

  // Returns the file that #include names.
  std::string header(const std::vector<Token>& line, std::string_view rest) {
    if (!line.empty() && line.front().kind == Kind::string) {
      const std::string& quoted = spellings_.text(line.front().spelling);
      return quoted.substr(1, quoted.size() - 2);
    }
    if (!rest.starts_with('<') && !rest.starts_with('"'))
      throw Problem("'#include' needs a \"file\" or a <file>");
    const std::size_t end = rest.find('>', 1);
    if (rest.front() == '"' || end == std::string_view::npos)
      throw Problem(std::string("this '#include' has no closing '") + (rest.front() == '"' ? '"' : '>') +
                    "'");
    return std::string(rest.substr(1, end - 1));
  }

  void nest(const Item& item) {
    const std::size_t here = out_.items.size();
    const Step step = item.step;
    if (step == Step::on_condition || step == Step::on_defined || step == Step::on_undefined) {
      open_.push_back({{here}, false});
      return;
    }
    if (step != Step::or_on_condition && step != Step::otherwise && step != Step::end) return;
    if (open_.empty()) return fail("'#" + word_of(step) + "' has no '#if' in this file", item.place);
    OpenCondition& condition = open_.back();
    out_.items[condition.branches.back()].next = here;
    if (step != Step::end && condition.otherwise_seen)
      fail(step == Step::otherwise ? "'#else' comes after another '#else'" : "'#elif' comes after '#else'",
           item.place);
    condition.otherwise_seen = condition.otherwise_seen || step == Step::otherwise;
    if (step != Step::end) return condition.branches.push_back(here);
    for (const std::size_t branch : condition.branches) out_.items[branch].end = here;
    open_.pop_back();
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Spellings& spellings_;
  TokenScan scan_;
  CutSource out_;
  std::vector<OpenCondition> open_;
  bool in_run_ = false;
};

}  // namespace

CutSource cut_source(std::string_view text, Spellings& spellings) {
  return SourceCut(text, spellings).run();
}

}  // namespace penumbra::preprocessing
