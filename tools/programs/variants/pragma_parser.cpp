#include "variants/pragma_parser.h"

#include <cstddef>
#include <map>
#include <utility>

#include "hlsl/identifier.h"
#include "input/nearest_name.h"
#include "variants/pragma_names.h"

namespace penumbra::variants {
namespace {

// The number of messages that pragma_reader.cpp keeps. A file that is included 4,096 times repeats its
// mistakes as often.
constexpr int kMostHints = 200;

std::vector<std::string> texts_of(const std::vector<preprocessing::Word>& words) {
  std::vector<std::string> texts;
  texts.reserve(words.size());
  for (const preprocessing::Word& word : words) texts.push_back(word.text);
  return texts;
}

}  // namespace

void PragmaParser::read(const preprocessing::DirectiveLine& directive, const std::string& file) {
  Line line{{}, directive.words, {file, directive.line, directive.column}};
  if (line.words.empty()) {
    warn(line.place, "'#pragma' without a name after it has no effect");
    return;
  }
  preprocessing::Word& first = line.words.front();
  const std::size_t end = std::min(first.text.find('('), first.text.size());
  line.name = first.text.substr(0, end);
  if (end == first.text.size()) {
    line.words.erase(line.words.begin());
  } else {
    first = {first.text.substr(end), first.line, first.column + static_cast<int>(end)};
  }
  if (read_entry_point(line) || read_keywords(line) || read_list(line) || read_other(line)) return;
  warn(line.place, "unknown pragma '" + line.name + "' has no effect" + hint(line.name, pragma_names()));
}

std::string PragmaParser::hint(const std::string& given, const std::vector<std::string>& known) {
  if (hints_ >= kMostHints) return {};
  ++hints_;
  const std::string nearest = nearest_name(given, known);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

Place PragmaParser::place_of(const Line& line, const preprocessing::Word& word) const {
  return {line.place.file, word.line, word.column};
}

// Many published shaders end a #pragma as a statement.
void PragmaParser::drop_semicolon(const Line& line, preprocessing::Word& word, const std::string& message) {
  if (word.text.back() != ';') return;
  word.text.pop_back();
  warn({line.place.file, word.line, word.column + static_cast<int>(word.text.size())}, message);
}

bool PragmaParser::read_entry_point(Line& line) {
  const std::optional<hlsl::Stage> stage = hlsl::find_stage(line.name);
  if (!stage || *stage == hlsl::Stage::compute) return false;
  if (line.words.empty()) {
    error(line.place, "'#pragma " + line.name + "' needs the name of a function");
    return true;
  }
  preprocessing::Word& function = line.words.front();
  if (function.text.size() > 1) drop_semicolon(line, function, "';' after the function's name has no effect");
  if (!hlsl::is_identifier(function.text)) {
    error(place_of(line, function), "'" + function.text + "' cannot be the name of a function");
    return true;
  }
  if (line.words.size() > 1)
    warn(place_of(line, line.words[1]), "what follows the function's name has no effect");
  const EntryPoint entry{*stage, function.text, line.place};
  for (EntryPoint& known : pragmas_.entry_points) {
    if (known.stage != *stage) continue;
    warn(line.place, "a second " + line.name + " entry point: '" + function.text + "' replaces '" +
                         known.function + "' of " + text_of(known.place));
    known = entry;
    return true;
  }
  pragmas_.entry_points.push_back(entry);
  return true;
}

bool PragmaParser::read_keywords(const Line& line) {
  if (built_in_sets(line.name)) {
    add_built_in(line);
    return true;
  }
  const std::optional<KeywordPragmaName> name = keyword_pragma_name(line.name);
  if (!name) return false;
  if (line.words.empty()) {
    warn(line.place, "'#pragma " + line.name + "' names no keyword");
  } else if (name->base == KeywordPragmaName::Base::dynamic_branch) {
    add_dynamic(line, name->local);
  } else {
    KeywordSet set = set_of(line);
    set.local = name->local;
    set.stages = name->stages;
    if (name->base == KeywordPragmaName::Base::shader_feature) {
      set.kind = KeywordSet::Kind::shader_feature;
      const bool alone = set.alternatives.size() == 1 && !set.alternatives.front().empty();
      if (alone) set.alternatives.insert(set.alternatives.begin(), Keywords{});
    }
    if (!set.alternatives.empty()) pragmas_.keyword_sets.push_back(std::move(set));
  }
  return true;
}

void PragmaParser::say(hlsl::Severity severity, const Place& place, const std::string& message) {
  constexpr std::size_t kMostOfALine = 8;
  if (place.file != said_at_.file || place.line != said_at_.line) said_errors_ = said_warnings_ = 0;
  said_at_ = place;
  std::size_t& said = severity == hlsl::Severity::error ? said_errors_ : said_warnings_;
  if (said++ < kMostOfALine)
    say_(severity, place,
         message + (said == kMostOfALine ? " (further ones of this line are not listed)" : ""));
}

// The limit is that of the Unity Manual, "Shader keyword limits".
constexpr std::size_t kMostKeywords = 65534;

bool PragmaParser::is_keyword(const preprocessing::Word& word, const Line& line) {
  if (is_empty_keyword(word.text)) return true;
  if (hlsl::is_identifier(word.text)) {
    if (keywords_.contains(word.text)) return true;
    if (keywords_.size() < kMostKeywords) return keywords_.insert(word.text).second;
    if (!std::exchange(said_too_many_, true))
      error(place_of(line, word), "'" + word.text + "' is one keyword too many; Unity allows a shader " +
                                      std::to_string(kMostKeywords));
    return false;
  }
  const bool comma = word.text.find(',') != std::string::npos;
  error(place_of(line, word), "'" + word.text + "' is not a keyword" +
                                  (comma ? "; keywords are separated by spaces, without commas"
                                         : "; keywords are letters, digits and '_'"));
  return false;
}

KeywordSet PragmaParser::set_of(const Line& line) {
  KeywordSet set;
  set.pragma = line.name;
  set.place = line.place;
  std::set<std::string> seen;
  for (const preprocessing::Word& word : line.words) {
    if (!is_keyword(word, line)) continue;
    const bool empty = is_empty_keyword(word.text);
    if (!seen.insert(empty ? "_" : word.text).second) {
      warn(place_of(line, word), "'" + word.text + "' appears twice in one set and counts once");
      continue;
    }
    set.alternatives.push_back(empty ? Keywords{} : Keywords{word.text});
  }
  return set;
}

void PragmaParser::add_built_in(const Line& line) {
  if (!line.words.empty())
    warn(place_of(line, line.words.front()), "'#pragma " + line.name + "' takes no keywords");
  BuiltInSets sets = *built_in_sets(line.name);
  for (std::vector<Keywords>& alternatives : sets.sets) {
    KeywordSet set;
    set.pragma = line.name;
    set.place = line.place;
    set.alternatives = std::move(alternatives);
    pragmas_.keyword_sets.push_back(std::move(set));
  }
  pragmas_.clauses.insert(pragmas_.clauses.end(), sets.clauses.begin(), sets.clauses.end());
}

void PragmaParser::add_dynamic(const Line& line, bool local) {
  for (const preprocessing::Word& word : line.words) {
    if (!is_keyword(word, line) || is_empty_keyword(word.text)) continue;
    pragmas_.dynamic_keywords.push_back({word.text, local, place_of(line, word)});
  }
}

bool PragmaParser::read_list(const Line& line) {
  if (line.name == "only_renderers") {
    read_renderers(line, pragmas_.only_renderers);
  } else if (line.name == "exclude_renderers") {
    read_renderers(line, pragmas_.excluded_renderers);
  } else if (line.name == "hardware_tier_variants") {
    read_renderers(line, pragmas_.tier_renderers);
  } else if (line.name == "skip_variants") {
    for (const preprocessing::Word& word : line.words) {
      if (!is_keyword(word, line)) continue;
      pragmas_.clauses.push_back(never(word.text, "#pragma skip_variants at " + text_of(line.place)));
    }
  } else {
    return false;
  }
  if (line.words.empty()) warn(line.place, "'#pragma " + line.name + "' names nothing");
  return true;
}

bool PragmaParser::read_other(const Line& line) {
  static const std::map<std::string, void (PragmaParser::*)(const Line&)> readers{
      {"kernel", &PragmaParser::read_kernel},
      {"surface", &PragmaParser::read_surface},
      {"target", &PragmaParser::read_target},
      {"require", &PragmaParser::read_requirement},
      {"instancing_options", &PragmaParser::read_instancing_options}};
  const auto reader = readers.find(line.name);
  if (reader != readers.end()) {
    (this->*reader->second)(line);
    return true;
  }
  if (!is_option_pragma(line.name)) return false;
  pragmas_.options.push_back({line.name, texts_of(line.words), line.place});
  return true;
}

void PragmaParser::read_kernel(const Line& line) {
  if (line.words.empty()) {
    error(line.place, "'#pragma kernel' needs the name of a function");
    return;
  }
  std::vector<preprocessing::Word> words = line.words;
  if (words.size() > 1 || words.back().text.size() > 1)
    drop_semicolon(line, words.back(), "';' at the end of '#pragma kernel' has no effect");
  if (words.back().text.empty()) words.pop_back();
  Kernel kernel{words.front().text, {}, line.place};
  if (!hlsl::is_identifier(kernel.function)) {
    error(place_of(line, words.front()), "'" + kernel.function + "' cannot be the name of a function");
    return;
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i].text;
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string macro = word.substr(0, equals);
    if (!hlsl::is_identifier(macro)) {
      error(place_of(line, words[i]), "'" + word + "' is not NAME or NAME=VALUE, without blanks");
      continue;
    }
    kernel.defines.emplace_back(macro, equals == word.size() ? "1" : word.substr(equals + 1));
  }
  pragmas_.kernels.push_back(std::move(kernel));
}

void PragmaParser::read_surface(const Line& line) {
  SurfaceFunction surface;
  surface.place = line.place;
  if (line.words.size() < 2) {
    error(line.place, "'#pragma surface' needs a function and a lighting model");
    return;
  }
  surface.function = line.words[0].text;
  surface.lighting_model = line.words[1].text;
  for (std::size_t i = 2; i < line.words.size(); ++i) surface.options.push_back(line.words[i].text);
  warn(line.place,
       "a surface shader: Unity's editor writes its vertex and fragment functions; without the "
       "editor it cannot be compiled");
  pragmas_.surface = std::move(surface);
}

void PragmaParser::read_target(const Line& line) {
  if (line.words.empty()) {
    error(line.place, "'#pragma target' needs a shader model, for example 3.5");
    return;
  }
  const std::optional<int> model = shader_model(line.words.front().text);
  if (!model) {
    error(place_of(line, line.words.front()),
          "'" + line.words.front().text +
              "' is not a shader model; known are 2.0 2.5 3.0 3.5 4.0 4.5 4.6 5.0 6.0 es3.0 es3.1 gl4.1");
    return;
  }
  ShaderTarget target{*model, {}, line.place};
  for (std::size_t i = 1; i < line.words.size(); ++i) {
    if (is_keyword(line.words[i], line)) target.keywords.push_back(line.words[i].text);
  }
  pragmas_.targets.push_back(std::move(target));
}

void PragmaParser::read_requirement(const Line& line) {
  Requirement requirement;
  requirement.place = line.place;
  bool after_colon = false;
  const auto take = [&](const preprocessing::Word& word) {
    if (word.text.empty()) return;
    if (after_colon) {
      if (is_keyword(word, line)) requirement.keywords.push_back(word.text);
      return;
    }
    const std::vector<std::string>& known = feature_names();
    requirement.features.push_back(word.text);
    if (std::find(known.begin(), known.end(), word.text) != known.end()) return;
    const std::string nearest = nearest_name(word.text, known);
    if (nearest.empty()) return;
    warn(place_of(line, word), "unknown feature '" + word.text + "'; did you mean '" + nearest + "'?");
  };
  for (const preprocessing::Word& word : line.words) {
    const std::size_t colon = word.text.find(':');
    if (colon == std::string::npos || after_colon) {
      take(word);
      continue;
    }
    take({word.text.substr(0, colon), word.line, word.column});
    after_colon = true;
    take({word.text.substr(colon + 1), word.line, word.column + static_cast<int>(colon) + 1});
  }
  if (requirement.features.empty()) {
    error(line.place, "'#pragma require' names no feature");
    return;
  }
  pragmas_.requirements.push_back(std::move(requirement));
}

void PragmaParser::read_renderers(const Line& line, std::vector<std::string>& renderers) {
  const std::vector<std::string>& known = renderer_names();
  for (const preprocessing::Word& word : line.words) {
    renderers.push_back(word.text);
    if (std::find(known.begin(), known.end(), word.text) != known.end()) continue;
    warn(place_of(line, word), "unknown renderer '" + word.text + "'" + hint(word.text, known));
  }
}

void PragmaParser::read_instancing_options(const Line& line) {
  const std::vector<std::string>& known = instancing_option_names();
  for (const preprocessing::Word& word : line.words) {
    const std::size_t colon = std::min(word.text.find(':'), word.text.size());
    const std::string option = word.text.substr(0, colon);
    if (std::find(known.begin(), known.end(), option) == known.end()) {
      warn(place_of(line, word), "unknown instancing option '" + option + "'" + hint(option, known));
    } else if (option == "procedural") {
      const std::string function = word.text.substr(std::min(colon + 1, word.text.size()));
      if (hlsl::is_identifier(function)) {
        pragmas_.procedural_function = function;
      } else {
        error(place_of(line, word), "'procedural' needs the name of a function: procedural:NAME");
      }
    }
  }
  pragmas_.options.push_back({line.name, texts_of(line.words), line.place});
}

void PragmaParser::finish() {
  std::set<std::string> dynamic;
  for (const DynamicKeyword& keyword : pragmas_.dynamic_keywords) dynamic.insert(keyword.name);
  std::erase_if(pragmas_.dynamic_keywords,
                [&, seen = std::set<std::string>()](const DynamicKeyword& keyword) mutable {
                  return !seen.insert(keyword.name).second;
                });
  for (KeywordSet& set : pragmas_.keyword_sets) {
    if (set.pragma == "multi_compile_instancing" && !pragmas_.procedural_function.empty())
      set.alternatives.push_back({"PROCEDURAL_INSTANCING_ON"});
    std::set<Keywords> kept;
    for (Keywords& alternative : set.alternatives) {
      for (const std::string& keyword : alternative) {
        if (!dynamic.contains(keyword)) continue;
        warn(set.place, "'" + keyword + "' is a dynamic_branch keyword, too: it makes no variants");
      }
      std::erase_if(alternative, [&](const std::string& keyword) { return dynamic.contains(keyword); });
    }
    std::erase_if(set.alternatives,
                  [&](const Keywords& alternative) { return !kept.insert(alternative).second; });
  }
  warn_of_shared_keywords();
}

// Sets for different stages may share keywords: each stage then sees one of them.
void PragmaParser::warn_of_shared_keywords() {
  std::map<std::string, std::vector<const KeywordSet*>> sets_with;
  for (const KeywordSet& set : pragmas_.keyword_sets) {
    if (built_in_sets(set.pragma)) continue;
    for (const std::string& keyword : keywords_of(set)) {
      std::vector<const KeywordSet*>& others = sets_with[keyword];
      const auto shared = std::find_if(others.begin(), others.end(), [&](const KeywordSet* other) {
        return other->stages.meets(set.stages) && text_of(other->place) != text_of(set.place);
      });
      if (shared != others.end())
        warn(set.place, "'" + keyword + "' stands in two keyword sets, here and at " +
                            text_of((*shared)->place) + ": Unity builds variants for both; declare it once");
      others.push_back(&set);
    }
  }
}

}  // namespace penumbra::variants
