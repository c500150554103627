#include "preprocessing/preprocessor.h"

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

#include "hlsl/expanded_text.h"
#include "preprocessing/condition.h"

namespace penumbra::preprocessing {

namespace {

class Output {
 public:
  // The names of files must outlive this object. Text before the first #line is of `main`.
  Output(const Spellings& spellings, const std::string& main) : spellings_(spellings), file_(&main) {}

  void go_to(const std::string& file) { next_file_ = &file; }

  void token(const Token& token, const Place& place) {
    if (sync_to(place.line))
      text_.append(static_cast<std::size_t>(place.column - 1), ' ');
    else if (blank_between(before_, token))
      text_ += ' ';
    text_ += spellings_.text(token.spelling);
    before_ = token;
  }

  // Copies tokens of one run, in which no macro is called.
  void copy(const CutSource& source, std::size_t first, std::size_t last) {
    if (first == last) return;
    token(source.tokens[first], source.places[first]);
    text_.append(source.printed, source.ends[first], source.ends[last - 1] - source.ends[first]);
    line_ = source.places[last - 1].line;
    before_ = source.tokens[last - 1];
  }

  std::string take() { return std::move(text_ += '\n'); }

 private:
  // Returns true if the text is now at the beginning of the line.
  bool sync_to(int line) {
    const bool same_file = file_ == next_file_ || *file_ == *next_file_;
    if (same_file && line == line_ && !text_.empty()) return false;
    file_ = next_file_;
    if (same_file && line >= line_ && line - line_ <= hlsl::most_empty_lines) {
      text_.append(static_cast<std::size_t>(line - line_), '\n');
    } else {
      if (!text_.empty()) text_ += '\n';
      text_.append("#line ").append(std::to_string(line)).append(" \"").append(*file_).append("\"\n");
    }
    line_ = line;
    return true;
  }

  const Spellings& spellings_;
  std::string text_;
  const std::string* file_;
  const std::string* next_file_ = nullptr;
  int line_ = 1;  // the current line of the text
  Token before_;
};

class Reading final : public Continuation {
 public:
  Reading(Spellings& spellings, Macros& macros, Expansion& expansion, Includes& includes,
          const std::string& main)
      : spellings_(spellings),
        macros_(macros),
        expansion_(expansion),
        includes_(includes),
        out_(spellings, main) {
    expansion_.continue_with(this);
  }
  ~Reading() override { expansion_.continue_with(nullptr); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  // Returns false after an error.
  bool read(const CutSource& source, std::string name) {
    Frame frame{source, names_.emplace_back(std::move(name))};
    Frame* const includer = std::exchange(frame_, &frame);
    out_.go_to(frame.name);
    bool right = true;
    try {
      if (!source.problem.empty()) throw Problem(source.problem, source.problem_place);
      while (right && frame.at < source.items.size()) right = step();
    } catch (const Problem& problem) {
      const Place place = problem.place.line > 0 ? problem.place : place_of_problem();
      report(frame.name, place, hlsl::Severity::error, problem.what());
      right = false;
    }
    frame_ = includer;
    if (includer != nullptr) out_.go_to(includer->name);
    return right;
  }

  std::string take() { return out_.take(); }
  std::vector<hlsl::Diagnostic> diagnostics() { return std::move(diagnostics_); }

  // Goes to the next run of text in the middle of a macro's call.
  bool go_on() override {
    const std::vector<Item>& items = frame_->source.items;
    for (++frame_->at; frame_->at < items.size();) {
      const Item& item = items[frame_->at];
      if (item.step == Step::include) throw Problem("#include among a macro's arguments", item.place);
      if (item.step != Step::run) {
        step();
        continue;
      }
      const Run& run = frame_->source.runs[item.index];
      read_text(run.first, run.last);
      return true;
    }
    return false;
  }

 private:
  struct Frame {
    const CutSource& source;
    const std::string& name;
    std::size_t at = 0;  // the item that is read
  };

  Place place_of_problem() const {
    const Item& item = frame_->source.items[std::min(frame_->at, frame_->source.items.size() - 1)];
    return item.step == Step::run ? expansion_.place() : item.place;
  }

  void report(const std::string& file, const Place& place, hlsl::Severity severity, std::string message) {
    diagnostics_.push_back({file, place.line, place.column, severity, std::move(message), {}});
  }

  // Reads an item and goes to the next. Returns false after an error in an included file.
  bool step() {
    Frame& frame = *frame_;
    const CutSource& source = frame.source;
    const Item& item = source.items[frame.at];
    switch (item.step) {
      case Step::run:
        run();
        break;
      case Step::define:
        define(source.definitions[item.index]);
        break;
      case Step::undef:
        macros_.undefine(static_cast<Spelling>(item.index));
        break;
      case Step::include:
        if (!include(source.includes[item.index], item.place)) return false;
        break;
      case Step::on_condition:
      case Step::on_defined:
      case Step::on_undefined:
        branch();
        return true;
      case Step::or_on_condition:
      case Step::otherwise:
        frame.at = item.end;
        return true;
      case Step::skipped:
        if (item.once) once_.insert(frame.name);
        break;
      case Step::end:
        break;
      case Step::problem:
        throw Problem(source.messages[item.index], item.place);
    }
    ++frame.at;
    return true;
  }

  // Goes to the first item of the active branch, or to the end of the condition.
  void branch() {
    const std::vector<Item>& items = frame_->source.items;
    while (items[frame_->at].step != Step::end && !chosen(items[frame_->at]))
      frame_->at = items[frame_->at].next;
    ++frame_->at;
  }

  bool chosen(const Item& item) {
    if (item.step == Step::otherwise) return true;
    const Token* const tokens = frame_->source.tokens.data();
    expansion_.begin_directive(item.place);
    if (item.step == Step::on_condition || item.step == Step::or_on_condition)
      return holds(tokens + item.first, tokens + item.last, expansion_, spellings_);
    if (item.index == known::open)
      throw Problem(item.step == Step::on_defined ? "'#ifdef' takes the name of one macro"
                                                  : "'#ifndef' takes the name of one macro",
                    item.place);
    return macros_.is_defined(static_cast<Spelling>(item.index)) == (item.step == Step::on_defined);
  }

  // A macro that is defined as something else is no error in FXC: from then on this definition is used.
  void define(const Definition& definition) {
    const Macros::Known other = macros_.define(definition, frame_->name);
    if (other.definition == nullptr || !told_.emplace(frame_->name, definition.place.line).second) return;
    const bool first = other.file == &names_.front();
    report(frame_->name, definition.place, hlsl::Severity::warning,
           "macro '" + spellings_.text(definition.name) + "' is defined as something else" +
               (first ? " before the first line"
                      : " at " + *other.file + ":" + std::to_string(other.definition->place.line)) +
               "; from here on this definition is used");
  }

  bool include(const std::string& asked, const Place& place) {
    IncludedFile file = includes_.enter(asked, frame_->name);
    if (!file.problem.empty()) throw Problem(file.problem, place);
    const bool right = once_.contains(file.name) || read(*file.source, std::move(file.name));
    includes_.leave();
    return right;
  }

  void read_text(std::size_t first, std::size_t last) {
    const CutSource& source = frame_->source;
    expansion_.read_text(source.tokens.data() + first, source.tokens.data() + last,
                         source.places.data() + first);
  }

  // A call may end in a later run.
  void run() {
    const CutSource& source = frame_->source;
    const Run* run = &source.runs[source.items[frame_->at].index];
    bool plain = mentions_no_macro(*run);
    for (std::size_t at = run->first; at < run->last;) {
      const std::size_t macro = plain ? run->last : next_macro(*run, at);
      if (run->bad >= at && run->bad < macro)
        throw Problem(message_for_bad(spellings_.text(source.tokens[run->bad].spelling)),
                      source.places[run->bad]);
      out_.copy(source, at, macro);
      if (macro == run->last) break;
      read_text(macro, run->last);
      expand();
      const Run* const now = &source.runs[source.items[frame_->at].index];
      if (now != run) plain = mentions_no_macro(*now);
      run = now;
      at = static_cast<std::size_t>(expansion_.position() - source.tokens.data());
    }
  }

  bool is_macro(Spelling name) const { return macros_.is_defined(name) || name == known::word_line; }

  bool mentions_no_macro(const Run& run) const {
    const auto names = frame_->source.names.begin();
    return std::none_of(names + static_cast<std::ptrdiff_t>(run.first_name),
                        names + static_cast<std::ptrdiff_t>(run.last_name),
                        [this](Spelling name) { return is_macro(name); });
  }

  std::size_t next_macro(const Run& run, std::size_t at) const {
    const std::vector<Token>& tokens = frame_->source.tokens;
    while (at < run.last && !(tokens[at].kind == Kind::identifier && is_macro(tokens[at].spelling))) ++at;
    return at;
  }

  // Expands a macro's name with its arguments.
  void expand() {
    do {
      Token token = expansion_.scan();
      if (token.kind == Kind::identifier && expansion_.expand(token)) continue;
      out_.token(token, expansion_.place());
    } while (!expansion_.at_bottom());
  }

  Spellings& spellings_;
  Macros& macros_;
  Expansion& expansion_;
  Includes& includes_;
  Output out_;
  Frame* frame_ = nullptr;
  std::deque<std::string> names_;  // of the files that are read: elements never move
  std::set<std::string> once_;
  std::set<std::pair<std::string, int>> told_;
  std::vector<hlsl::Diagnostic> diagnostics_;
};

}  // namespace

Preprocessed Preprocessor::run(const CutSource& definitions, const CutSource& source, const std::string& name,
                               Includes& includes) {
  Preprocessed out;
  {
    Reading reading(spellings_, macros_, expansion_, includes, name);
    if (reading.read(definitions, name) && reading.read(source, name)) out.text = reading.take();
    out.diagnostics = reading.diagnostics();
  }
  expansion_.restart();
  macros_.clear();
  return out;
}

}  // namespace penumbra::preprocessing
