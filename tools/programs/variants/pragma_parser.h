// Reads one #pragma line after another into Pragmas. Internal to this folder.
#pragma once

#include <set>

#include "hlsl/diagnostic.h"
#include "preprocessing/directive_lines.h"
#include "variants/pragmas.h"

namespace penumbra::variants {

// Receives messages: severity, location, text.
using Say = std::function<void(hlsl::Severity, const Place&, const std::string&)>;

class PragmaParser {
 public:
  PragmaParser(Pragmas& pragmas, Say say) : pragmas_(pragmas), say_(std::move(say)) {}

  void read(const preprocessing::DirectiveLine& directive, const std::string& file);

  // Makes the checks that need all lines: procedural instancing, and keywords that are both dynamic and
  // static.
  void finish();

 private:
  struct Line {
    std::string name;
    std::vector<preprocessing::Word> words;  // words after the name
    Place place;
  };

  void drop_semicolon(const Line& line, preprocessing::Word& word, const std::string& message);
  bool read_entry_point(Line& line);
  bool read_keywords(const Line& line);
  bool read_list(const Line& line);
  bool read_other(const Line& line);

  void read_kernel(const Line& line);
  void read_surface(const Line& line);
  void read_target(const Line& line);
  void read_requirement(const Line& line);
  void read_renderers(const Line& line, std::vector<std::string>& renderers);
  void read_instancing_options(const Line& line);
  void add_built_in(const Line& line);
  void add_dynamic(const Line& line, bool local);
  void warn_of_shared_keywords();
  KeywordSet set_of(const Line& line);
  bool is_keyword(const preprocessing::Word& word, const Line& line);

  // Returns "; did you mean 'NAME'?" for the first messages; empty for later ones and where no name is near.
  std::string hint(const std::string& given, const std::vector<std::string>& known);
  Place place_of(const Line& line, const preprocessing::Word& word) const;
  // Emits only a few messages of a severity for one line: each message holds the line, which may have a
  // million words.
  void say(hlsl::Severity severity, const Place& place, const std::string& message);
  void error(const Place& place, const std::string& message) { say(hlsl::Severity::error, place, message); }
  void warn(const Place& place, const std::string& message) { say(hlsl::Severity::warning, place, message); }

  Pragmas& pragmas_;
  Say say_;
  Place said_at_;                  // the last place of a message
  std::size_t said_errors_ = 0;    // errors of its line
  std::size_t said_warnings_ = 0;  // warnings of its line
  std::set<std::string> keywords_;
  bool said_too_many_ = false;
  int hints_ = 0;
};

}  // namespace penumbra::variants
