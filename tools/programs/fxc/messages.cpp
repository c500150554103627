#include "fxc/messages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "hlsl/token_place.h"

namespace penumbra::fxc {

namespace {

// FXC itself acts on these pragmas.
constexpr std::array<std::string_view, 4> kPragmasOfFxc{"warning", "pack_matrix", "def", "message"};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_for_fxc(std::string_view line) {
  line = without_blanks(line);
  if (!line.starts_with('#')) return true;
  line = without_blanks(line.substr(1));
  constexpr std::string_view pragma = "pragma";
  if (!line.starts_with(pragma)) return false;
  line = without_blanks(line.substr(pragma.size()));
  return std::any_of(kPragmasOfFxc.begin(), kPragmasOfFxc.end(),
                     [&](std::string_view name) { return line.starts_with(name); });
}

// A line of FXC's messages: "file(line,first-last): warning X3206: text", or without the place.
struct Said {
  int line = 0;
  int column = 0;
  hlsl::Severity severity = hlsl::Severity::error;
  std::string text;
};

// FXC has no severity in its message that memory is used up: "folder/Shader@0x000012(1,10026): memory
// exhausted".
constexpr std::string_view kOwnName = "Shader@0x";

int number(std::string_view& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() ? value : 0;
}

// The place is the text "file(line,first-last): ".
void read_place(std::string_view place, Said& said) {
  const std::size_t open = place.rfind('(');
  if (open == std::string_view::npos) return;
  std::string_view numbers = place.substr(open + 1);
  said.line = number(numbers);
  if (!numbers.starts_with(',')) return;
  numbers.remove_prefix(1);
  said.column = number(numbers);
}

std::optional<Said> said_in(std::string_view line) {
  for (const auto& [word, severity] : {std::pair{std::string_view("error X"), hlsl::Severity::error},
                                       std::pair{std::string_view("warning X"), hlsl::Severity::warning}}) {
    const std::size_t at = line.find(word);
    if (at == std::string_view::npos) continue;
    Said said{0, 0, severity, std::string(without_blanks(line.substr(at + word.size() - 1)))};
    read_place(line.substr(0, at), said);
    return said;
  }
  const std::size_t own = line.find(kOwnName);
  if (const std::size_t end = line.find("): ", own);
      own != std::string_view::npos && end != std::string_view::npos) {
    Said said{0, 0, hlsl::Severity::error, std::string(without_blanks(line.substr(end + 2)))};
    read_place(line.substr(0, end), said);
    return said;
  }
  return std::nullopt;
}

constexpr std::size_t kCodeLength = 6;  // "X3013:"

// The candidates of a call are messages of their own, with the same place and code.
bool continues(const Said& before, const Said& said) {
  if (before.line != said.line || before.column != said.column || said.text.size() <= kCodeLength ||
      before.text.compare(0, kCodeLength, said.text, 0, kCodeLength) != 0)
    return false;
  const std::string_view rest = std::string_view(said.text).substr(kCodeLength);
  return rest.starts_with("    ") || rest.starts_with(" Possible ");
}

std::vector<Said> read_messages(const std::string& messages) {
  std::vector<Said> list;
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);) {
    const std::string_view text = without_blanks(line);
    if (text.empty()) continue;
    std::optional<Said> said = said_in(text);
    if (said && !list.empty() && continues(list.back(), *said))
      list.back().text.append("; ").append(without_blanks(std::string_view(said->text).substr(kCodeLength)));
    else if (said)
      list.push_back(*std::move(said));
    else if (!list.empty())  // the candidates of an overloaded call, and similar
      list.back().text.append("; ").append(text);
    else
      list.push_back({0, 0, hlsl::Severity::error, std::string(text)});
  }
  return list;
}

// Finds tokens of a text by line and column.
class TextPlaces {
 public:
  TextPlaces(const std::string& expanded, const std::string& main_file)
      : text_(expanded), tokens_(expanded, main_file) {
    lines_.push_back(0);
    for (std::size_t at = expanded.find('\n'); at != std::string::npos; at = expanded.find('\n', at + 1))
      lines_.push_back(at + 1);
  }

  hlsl::TokenPlace at(int line, int column, const hlsl::SourceFiles& sources) const {
    if (line < 1 || static_cast<std::size_t>(line) > lines_.size() || tokens_.size() == 0) return {};
    const std::size_t offset =
        lines_[static_cast<std::size_t>(line) - 1] + static_cast<std::size_t>(std::max(column, 1) - 1);
    std::size_t first = 0;  // the last token that begins at the offset or before
    for (std::size_t count = tokens_.size(); count > 1;) {
      const std::size_t half = count / 2;
      if (offset_of(first + half) <= offset) first += half;
      count -= half;
    }
    return tokens_.at(first, sources);
  }

 private:
  std::size_t offset_of(std::size_t token) const {
    return static_cast<std::size_t>(tokens_[token].spelling.data() - text_.data());
  }

  const std::string& text_;
  hlsl::TokenPlaces tokens_;
  std::vector<std::size_t> lines_;
};

}  // namespace

std::string text_for_fxc(const std::string& expanded) {
  std::string text = expanded;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (!is_for_fxc(std::string_view(text).substr(begin, end - begin)))
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin),
                text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    begin = end + 1;
  }
  return text;
}

std::vector<hlsl::Diagnostic> diagnostics_of(const std::string& messages, const std::string& expanded,
                                             const std::string& main_file, const hlsl::SourceFiles& sources) {
  std::vector<hlsl::Diagnostic> list;
  const std::vector<Said> all = read_messages(messages);
  if (all.empty()) return list;
  const TextPlaces places(expanded, main_file);
  std::set<std::tuple<std::string, int, int, std::string>> known;
  for (const Said& said : all) {
    hlsl::TokenPlace place = places.at(said.line, said.column, sources);
    if (place.file.empty()) place.file = main_file;
    if (!known.emplace(place.file, place.line, place.column, said.text).second) continue;
    list.push_back({place.file, place.line, place.column, said.severity, said.text,
                    place.line > 0 ? sources.line(place.file, place.line) : std::string()});
  }
  return list;
}

}  // namespace penumbra::fxc
