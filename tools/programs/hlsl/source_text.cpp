#include "hlsl/source_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "hlsl/identifier.h"
#include "input/text_file.h"

namespace penumbra::hlsl {

std::string normalise_source(std::string_view bytes) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\r', at), bytes.size());
    text.append(bytes.substr(at, end - at));
    if (end < bytes.size() && (end + 1 == bytes.size() || bytes[end + 1] != '\n')) text += '\n';
    at = end + 1;
  }
  return text;
}

namespace {

constexpr std::uintmax_t kLargestSource = std::uintmax_t{64} << 20U;  // bytes

// #line directives and messages name a file between quotation marks on one line.
bool has_printable_name(const std::filesystem::path& file) {
  const std::string name = file.string();
  return std::none_of(name.begin(), name.end(),
                      [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

// Returns whether `at` is after a '#' that begins its line.
bool follows_hash(const std::string& text, std::size_t at) {
  while (at > 0 && is_blank(text[at - 1])) --at;
  if (at == 0 || text[--at] != '#') return false;
  while (at > 0 && is_blank(text[at - 1])) --at;
  return at == 0 || text[at - 1] == '\n';
}

// A #line directive refers to another file, in which nothing could be shown or corrected.
void blank_line_directives(std::string& text) {
  constexpr std::string_view word = "line";
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const char after = at + word.size() < text.size() ? text[at + word.size()] : '\n';
    if ((!is_blank(after) && after != '\n') || !follows_hash(text, at)) continue;
    for (std::size_t i = text.rfind('#', at); i < text.size(); ++i) {
      if (text[i] == '\n' && text[i - 1] != '\\') break;
      if (text[i] != '\n' && text[i] != '\\') text[i] = ' ';
    }
  }
}

}  // namespace

SourceRead read_source(const std::filesystem::path& file) {
  if (!has_printable_name(file))
    return {{},
            "its path holds a quotation mark or a control character, which #line cannot express; rename it"};
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return {{}, "no such file"};
  if (error) return {{}, error.message()};
  if (std::filesystem::is_directory(status)) return {{}, "it is a folder, not a file"};
  if (!std::filesystem::is_regular_file(status)) return {{}, "it is not a regular file"};
  if (std::filesystem::file_size(file, error) > kLargestSource && !error)
    return {{}, "it has more than " + std::to_string(kLargestSource) + " bytes, the limit of a source file"};
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {{}, std::strerror(errno)};
  const std::optional<std::string> bytes = rest_of(stream);
  if (!bytes) return {{}, "reading it failed"};
  std::string text = normalise_source(*bytes);
  blank_line_directives(text);
  return {std::move(text), {}};
}

const SourceFiles::Files& SourceFiles::files() const {
  static const Files none;
  return files_ ? *files_ : none;
}

void SourceFiles::add(const std::string& name, std::string text) {
  add(name, std::make_shared<const std::string>(std::move(text)));
}

void SourceFiles::add(const std::string& name, Text text) {
  if (contains(name)) return;
  if (!files_) files_ = std::make_shared<Files>();
  if (files_.use_count() > 1) files_ = std::make_shared<Files>(*files_);
  files_->texts.emplace(name, std::move(text));
  files_->names.push_back(name);
}

std::string SourceFiles::line(const std::string& name, int number) const {
  if (!contains(name) || number < 1) return {};
  const std::string& text = this->text(name);
  std::size_t start = 0;
  for (int i = 1; i < number; ++i) {
    start = text.find('\n', start);
    if (start == std::string::npos) return {};
    ++start;
  }
  return text.substr(start, text.find('\n', start) - start);
}

}  // namespace penumbra::hlsl
