#include "preprocessing/preprocessor.h"

#include <algorithm>
#include <utility>

#include "preprocessing/condition.h"
#include "preprocessing/cut_source.h"
#include "preprocessing/token.h"

namespace penumbra::preprocessing {

namespace {

// The text that glslang's preprocessor produces from tokens and their lines (DoPreprocessing and
// SourceLineSynchronizer in its ShaderLang.cpp).

class Output {
 public:
  explicit Output(const Spellings& spellings) : spellings_(spellings) {}

  // `place.column` may be 0 for a token that begins no line.
  void token(const Token& token, int line, int column);
  // Copies tokens of one run, in which no macro is called.
  void copy(const CutSource& source, std::size_t first, std::size_t last);
  // Emits a directive on `line`: the next line is line `next` of the file.
  void line_directive(int line, int next, const std::string& file);

  std::string take();

 private:
  bool sync_to(int line);
  void begin(const Token& token, int line, int column);

  const Spellings& spellings_;
  std::string text_;
  int line_ = -1;  // the current line of the text
  Token before_;
};

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

constexpr int deepest_nesting = 60;  // conditions; glslang's limit is 65
constexpr std::size_t longest_name = 1000;

class Reading {
 public:
  Reading(Spellings& spellings, Macros& macros, Expansion& expansion, Includes& includes)
      : spellings_(spellings), macros_(macros), expansion_(expansion), includes_(includes), out_(spellings) {}

  void read(const CutSource& source, const std::string& name) {
    if (!source.usual) throw Unusual("source text that only glslang can read");
    if (depth_ + source.depth > deepest_nesting) throw Unusual("conditions nested too deeply");
    for (std::size_t i = 0; i < source.items.size();) i = step(source, i, name);
  }

  std::string take() { return out_.take(); }

 private:
  // Returns the item to continue with.
  std::size_t step(const CutSource& source, std::size_t at, const std::string& name) {
    const Item& item = source.items[at];
    if (item.whole_float && depth_ == 0) throw Unusual("a number like 1f");
    switch (item.step) {
      case Step::run:
        run(source, source.runs[item.index]);
        return at + 1;
      case Step::define:
        macros_.define(source.definitions[item.index]);
        return at + 1;
      case Step::undef:
        if (item.malformed) throw Unusual("#undef");
        macros_.undefine(static_cast<Spelling>(item.index));
        return at + 1;
      case Step::include:
        include(source.includes[item.index], item.line, name);
        return at + 1;
      case Step::on_condition:
      case Step::on_defined:
      case Step::on_undefined:
        ++depth_;
        return branch(source, at);
      case Step::or_on_condition:
      case Step::otherwise:
        return item.end;
      case Step::end:
        --depth_;
        return at + 1;
      case Step::unusual:
        break;
    }
    throw Unusual("a directive that only glslang can read");
  }

  // Returns the first item of the active branch, or the end of the condition.
  std::size_t branch(const CutSource& source, std::size_t at) {
    while (source.items[at].step != Step::end && !chosen(source, source.items[at]))
      at = source.items[at].next;
    return source.items[at].step == Step::end ? at : at + 1;
  }

  bool chosen(const CutSource& source, const Item& item) {
    if (item.step == Step::otherwise) return true;
    if (item.malformed) throw Unusual("#ifdef without an identifier");
    const Token* const tokens = source.tokens.data();
    if (item.step == Step::on_condition || item.step == Step::or_on_condition)
      return holds(tokens + item.first, tokens + item.last, expansion_, macros_, spellings_);
    return macros_.is_defined(static_cast<Spelling>(item.index)) == (item.step == Step::on_defined);
  }

  void include(const Include& include, int line, const std::string& includer) {
    const std::optional<IncludedFile> file = includes_.enter(include.name, includer);
    if (!file) throw Unusual("an include that is not found");
    if (file->name.size() > longest_name || file->name.find_first_of("\"\n\r") != std::string::npos)
      throw Unusual("a file name that #line cannot express");
    if (file->source != nullptr) {
      out_.line_directive(line, 1, file->name);
      read(*file->source, file->name);
      out_.line_directive(file->source->lines + 1, line + 1, includer);
    }
    includes_.leave();
  }

  void run(const CutSource& source, const Run& run) {
    const auto name = source.names.begin();
    const bool plain = std::none_of(name + static_cast<std::ptrdiff_t>(run.first_name),
                                    name + static_cast<std::ptrdiff_t>(run.last_name),
                                    [&](Spelling each) { return macros_.is_defined(each); });
    for (std::size_t at = run.first; at < run.last;) {
      const std::size_t macro = plain ? run.last : next_macro(source, at, run.last);
      out_.copy(source, at, macro);
      at = macro == run.last ? macro : expand(source, macro, run.last);
    }
  }

  std::size_t next_macro(const CutSource& source, std::size_t at, std::size_t last) const {
    while (at < last &&
           !(source.tokens[at].kind == Kind::identifier && macros_.is_defined(source.tokens[at].spelling)))
      ++at;
    return at;
  }

  // Expands a macro's name with its arguments. Returns the token to continue with.
  std::size_t expand(const CutSource& source, std::size_t name, std::size_t last) {
    const Token* const tokens = source.tokens.data();
    expansion_.read_text(tokens + name, tokens + last, source.places.data() + name);
    do {
      Read read = expansion_.scan();
      expansion_.paste(read);
      if (read.token.kind == Kind::identifier && expansion_.expand(read, false)) continue;
      out_.token(read.token, read.line, read.column);
    } while (!expansion_.at_bottom());
    return static_cast<std::size_t>(expansion_.position() - tokens);
  }

  Spellings& spellings_;
  Macros& macros_;
  Expansion& expansion_;
  Includes& includes_;
  Output out_;
  int depth_ = 0;
};

}  // namespace

std::optional<std::string> Preprocessor::run(const CutSource& definitions, const CutSource& source,
                                             const std::string& name, Includes& includes) {
  Reading reading(spellings_, macros_, expansion_, includes);
  std::optional<std::string> text;
  try {
    reading.read(definitions, name);
    reading.read(source, name);
    text = reading.take();
  } catch (const Unusual&) {
    text.reset();
  }
  expansion_.clear();
  macros_.clear();
  return text;
}

}  // namespace penumbra::preprocessing
