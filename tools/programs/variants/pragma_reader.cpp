#include <cctype>

#include "preprocessing/directive_lines.h"
#include "preprocessing/macro_table.h"
#include "variants/pragma_parser.h"
#include "variants/pragmas.h"

namespace penumbra::variants {
namespace {

constexpr std::size_t most_messages = 200;
constexpr std::size_t most_files = 4096;
constexpr std::size_t most_bytes = std::size_t{64} << 20U;
constexpr std::size_t deepest_include = 100;

// A text whose lines were found once, for the source line of every message.
class NumberedText {
 public:
  explicit NumberedText(std::string text) : text_(std::move(text)), starts_{0} {
    for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', at + 1))
      starts_.push_back(at + 1);
  }
  const std::string& text() const { return text_; }
  std::string line(int number) const {
    if (number < 1 || static_cast<std::size_t>(number) > starts_.size()) return {};
    const std::size_t start = starts_[static_cast<std::size_t>(number) - 1];
    return text_.substr(start, text_.find('\n', start) - start);
  }

 private:
  std::string text_;
  std::vector<std::size_t> starts_;
};

std::string leading_name(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size() &&
         (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_')) {
    ++end;
  }
  return text.substr(0, end);
}

// Returns "name" or <name> without the quotes; empty when it is neither.
std::string quoted_name(const std::string& rest) {
  if (rest.size() < 2 || (rest[0] != '"' && rest[0] != '<')) return {};
  const std::size_t close = rest.find(rest[0] == '"' ? '"' : '>', 1);
  return close == std::string::npos ? std::string() : rest.substr(1, close - 1);
}

class PragmaReader {
 public:
  explicit PragmaReader(const ProgramText& program)
      : program_(program),
        parser_(pragmas_, [this](hlsl::Severity severity, const Place& place, const std::string& message) {
          say(severity, place, message);
        }) {
    for (const auto& [name, value] : program.defines) macros_.define(name + " " + value);
  }

  Pragmas read() {
    read_file(program_.file, program_.text);
    parser_.finish();
    warn_of_keyword_conditions();
    return std::move(pragmas_);
  }

 private:
  // The state of one #if ... #endif.
  struct Branch {
    bool outer = true;  // true if the text around it counts
    bool taken = false;
    bool active = false;
    std::set<std::string> consulted;
    std::optional<Place> first_pragma;
  };

  void say(hlsl::Severity severity, const Place& place, const std::string& message) {
    if (pragmas_.diagnostics.size() >= most_messages) return;
    const auto text = texts_.find(place.file);
    pragmas_.diagnostics.push_back({place.file, place.line, place.column, severity, message,
                                    text == texts_.end() ? "" : text->second.line(place.line)});
  }

  bool active() const { return branches_.empty() || branches_.back().active; }

  void read_file(const std::string& name, const std::string& text) {
    bytes_ += text.size();
    const auto [numbered, is_new] = texts_.try_emplace(name, text);
    if (is_new) pragmas_.files.push_back(name);
    open_.push_back(name);
    const std::size_t outer_branches = branches_.size();
    for (const preprocessing::DirectiveLine& line : preprocessing::directive_lines(numbered->second.text()))
      read_directive(line, name, outer_branches);
    while (branches_.size() > outer_branches) close_branch();
    open_.pop_back();
  }

  void read_directive(const preprocessing::DirectiveLine& line, const std::string& file,
                      std::size_t outer_branches) {
    if (read_condition(line, file, outer_branches)) return;
    if (line.name == "pragma" && !branches_.empty() && !branches_.back().first_pragma)
      branches_.back().first_pragma = Place{file, line.line, line.column};
    if (!active()) return;
    if (line.name == "pragma") {
      if (!line.words.empty() && line.words.front().text == "once") once_.insert(file);
      parser_.read(line, file);
    } else if (line.name == "define") {
      macros_.define(line.rest);
    } else if (line.name == "undef") {
      macros_.undefine(leading_name(line.rest));
    } else if (line.name == "include_with_pragmas") {
      include(line, file);
    }
  }

  bool read_condition(const preprocessing::DirectiveLine& line, const std::string& file,
                      std::size_t outer_branches) {
    const bool inside = branches_.size() > outer_branches;
    if (line.name == "if" || line.name == "ifdef" || line.name == "ifndef") {
      Branch branch;
      branch.outer = active();
      branches_.push_back(std::move(branch));
      take_if(holds(line, file));
    } else if (line.name == "elif" && inside) {
      const bool open = branches_.back().outer && !branches_.back().taken;
      branches_.back().active = false;
      if (open) take_if(holds(line, file));
    } else if (line.name == "else" && inside) {
      branches_.back().active = branches_.back().outer && !branches_.back().taken;
      branches_.back().taken = true;
    } else if (line.name == "endif" && inside) {
      close_branch();
    } else {
      return line.name == "elif" || line.name == "else" || line.name == "endif";
    }
    return true;
  }

  void take_if(bool condition) {
    Branch& branch = branches_.back();
    branch.active = branch.outer && condition;
    branch.taken = branch.taken || condition;
  }

  bool holds(const preprocessing::DirectiveLine& line, const std::string& file) {
    Branch& branch = branches_.back();
    if (!branch.outer) return false;
    if (line.name == "ifdef" || line.name == "ifndef") {
      const std::string name = leading_name(line.rest);
      branch.consulted.insert(name);
      return macros_.is_defined(name) == (line.name == "ifdef");
    }
    const preprocessing::Condition condition = macros_.evaluate(line.rest);
    branch.consulted.insert(condition.consulted.begin(), condition.consulted.end());
    if (!condition.problem.empty())
      say(hlsl::Severity::warning, {file, line.line, line.column},
          "this condition cannot be evaluated, and the pragmas it guards may be misread: " +
              condition.problem);
    return condition.holds;
  }

  void include(const preprocessing::DirectiveLine& line, const std::string& file) {
    const Place place{file, line.line, line.column};
    const std::string name = quoted_name(line.rest);
    if (name.empty()) {
      say(hlsl::Severity::error, place, "'#include_with_pragmas' needs a file name in quotes");
      return;
    }
    const std::optional<IncludedText> found =
        program_.find_included ? program_.find_included(name, file) : std::nullopt;
    if (!found) {
      say(hlsl::Severity::warning, place, "cannot find '" + name + "': its pragmas are ignored");
      return;
    }
    if (once_.contains(found->name)) return;
    if (open_.size() >= deepest_include) {
      if (!std::exchange(too_deep_, true))
        say(hlsl::Severity::error, place,
            "files include each other more than " + std::to_string(deepest_include) + " deep, down to '" +
                found->name + "'; add an include guard or '#pragma once'");
      return;
    }
    if (++includes_ > most_files || bytes_ + found->text.size() > most_bytes) {
      if (includes_ == most_files + 1)
        say(hlsl::Severity::error, place, "too many files are included; the pragmas of the rest are ignored");
      includes_ = most_files + 1;
      return;
    }
    read_file(found->name, found->text);
  }

  void close_branch() {
    Branch closed = std::move(branches_.back());
    branches_.pop_back();
    if (!closed.first_pragma) return;
    if (!branches_.empty() && !branches_.back().first_pragma)
      branches_.back().first_pragma = closed.first_pragma;
    conditional_.push_back(std::move(closed));
  }

  void warn_of_keyword_conditions() {
    std::set<std::string> keywords;
    for (const KeywordSet& set : pragmas_.keyword_sets)
      for (const std::string& keyword : keywords_of(set)) keywords.insert(keyword);
    for (const Branch& branch : conditional_) {
      for (const std::string& name : branch.consulted) {
        if (!keywords.contains(name)) continue;
        say(hlsl::Severity::warning, *branch.first_pragma,
            "this pragma depends on the keyword '" + name +
                "', which Unity does not define while it reads pragmas");
      }
    }
  }

  const ProgramText& program_;
  Pragmas pragmas_;
  PragmaParser parser_;
  preprocessing::MacroTable macros_;
  std::map<std::string, NumberedText> texts_;
  std::set<std::string> once_;
  std::vector<std::string> open_;
  std::vector<Branch> branches_;
  std::vector<Branch> conditional_;  // closed branches that have a pragma in them
  std::size_t includes_ = 0;
  std::size_t bytes_ = 0;
  bool too_deep_ = false;
};

bool has_stage(const Pragmas& pragmas, hlsl::Stage stage) {
  return std::any_of(pragmas.entry_points.begin(), pragmas.entry_points.end(),
                     [&](const EntryPoint& entry) { return entry.stage == stage; });
}

}  // namespace

Pragmas read_pragmas(const ProgramText& program) {
  return PragmaReader(program).read();
}

bool compiles_for(const Pragmas& pragmas, const std::string& renderer) {
  if (contains(pragmas.excluded_renderers, renderer)) return false;
  return pragmas.only_renderers.empty() || contains(pragmas.only_renderers, renderer);
}

bool compiles_with_dxc(const Pragmas& pragmas, const std::string& renderer) {
  return std::any_of(pragmas.options.begin(), pragmas.options.end(), [&](const PragmaOption& option) {
    const bool named = option.arguments.empty() || contains(option.arguments, renderer);
    return named && (option.name == "use_dxc" || option.name == "require_dxc");
  });
}

int shader_target(const Pragmas& pragmas, const Keywords& variant) {
  int model = 25;
  if (has_stage(pragmas, hlsl::Stage::geometry)) model = 40;
  if (has_stage(pragmas, hlsl::Stage::hull) || has_stage(pragmas, hlsl::Stage::domain)) model = 46;
  if (!pragmas.kernels.empty()) model = 50;
  // multi_compile_instancing requires `instancing` of the variants with its keywords, which is target 3.5
  // (docs.unity3d.com/Manual/SL-ShaderCompileTargets.html).
  if (contains(variant, "INSTANCING_ON") || contains(variant, "PROCEDURAL_INSTANCING_ON"))
    model = std::max(model, 35);
  for (const ShaderTarget& target : pragmas.targets) {
    const bool applies = target.keywords.empty() ||
                         std::any_of(target.keywords.begin(), target.keywords.end(),
                                     [&](const std::string& keyword) { return contains(variant, keyword); });
    if (applies) model = std::max(model, target.model);
  }
  return model;
}

}  // namespace penumbra::variants
