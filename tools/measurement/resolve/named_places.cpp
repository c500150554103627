#include "resolve/named_places.h"

#include <algorithm>
#include <cctype>

#include "shaders/reflect.h"

namespace penumbra::resolve {
namespace {

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Returns the first line of any text that has the name as a word, or 0.
int line_of_name(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool whole = (at == 0 || !is_name_character(text[at - 1])) &&
                       (end == text.size() || !is_name_character(text[end]));
    if (whole)
      return static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) +
             1;
  }
  return 0;
}

// Returns the place in the first file that was read and has the name. The user's own file is read before
// those that it includes.
std::string place_of_name(const hlsl::SourceFiles& sources, const std::string& name) {
  for (const std::string& file : sources.names()) {
    const int line = line_of_name(sources.text(file), name);
    if (line != 0) return file + ":" + std::to_string(line);
  }
  return "";
}

}  // namespace

std::map<std::string, std::string> named_places(const std::vector<std::uint32_t>& spirv,
                                                const hlsl::SourceFiles& sources,
                                                const std::string& function) {
  std::map<std::string, std::string> places;
  const auto add = [&](const std::string& name) {
    const std::string place = place_of_name(sources, name);
    if (!place.empty()) places[name] = place;
  };
  add(function);
  for (const shaders::Resource& resource : shaders::reflect(spirv).resources) {
    add(resource.name);
    for (const shaders::UniformMember& member : resource.members) {
      if (member.read) add(member.name);
    }
  }
  return places;
}

}  // namespace penumbra::resolve
