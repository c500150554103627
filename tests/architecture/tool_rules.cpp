#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <sstream>

#include "architecture/rules.h"
#include "architecture/source_lines.h"

namespace penumbra::architecture {
namespace {

constexpr std::array<std::string_view, 22> kRooms{
    "cli",           "study",       "lighting",   "reference", "resolve",    "scene",
    "cost",          "gpu",         "validation", "lint",      "techniques", "shaders",
    "preprocessing", "preparation", "variants",   "shaderlab", "project",    "hlsl",
    "spirv",         "parameters",  "platform",   "input"};

std::size_t place_of(std::string_view room) {
  return static_cast<std::size_t>(std::find(kRooms.begin(), kRooms.end(), room) - kRooms.begin());
}

bool is_room(std::string_view name) {
  return place_of(name) < kRooms.size();
}

bool may_use(std::string_view user, std::string_view used) {
  if (user == used) return true;
  if (user == "parameters") return used == "platform" || used == "input";
  const bool reads_shaders = place_of(user) >= place_of("validation");
  if (reads_shaders && used == "parameters") return false;
  return place_of(user) < place_of(used);
}

}  // namespace

Violations tool_includes_point_down(const Tree& tree) {
  Violations found;
  for (const Include& include : includes_of(tree, "tools/")) {
    const std::string user = folder_below(include.path, "tools/");
    const std::string used = folder_below(include.target, "");
    if (used == "..") {
      found.push_back(violation(include.path, include.line, "names a room by '..'; name it from tools/"));
    }
    if (!user.empty() && !is_room(user)) {
      found.push_back(
          violation(include.path, include.line, "'" + user + "' has no place in the order of rooms"));
    } else if (is_room(used) && !may_use(user, used)) {
      found.push_back(violation(include.path, include.line, user + " must not include " + include.target));
    }
  }
  return found;
}

Violations tool_links_point_down(const Tree& tree) {
  static const std::regex alias("penumbra::(\\w+)");
  static const std::set<std::string> other_lists{"SOURCES", "PUBLIC_LIBRARIES", "PRIVATE_LIBRARIES"};
  Violations found;
  for (const auto& [path, text] : tree) {
    const std::string user = folder_below(path, "tools/");
    if (user.empty() || path != "tools/" + user + "/CMakeLists.txt") continue;
    bool in_uses = false;
    for_each_line(text, [&, &file = path](int number, const std::string& line) {
      const auto check = [&](const std::string& used) {
        if (is_room(used) && !may_use(user, used)) {
          found.push_back(violation(file, number, std::string(user).append(" must not link ").append(used)));
        }
      };
      const std::string code = line.substr(0, line.find('#'));
      for (std::sregex_iterator it(code.begin(), code.end(), alias), end; it != end; ++it) check((*it)[1]);
      std::istringstream words(std::regex_replace(code, std::regex("[()]"), " $& "));
      for (std::string word; words >> word;) {
        if (word == "USES") {
          in_uses = true;
        } else if (word == ")" || other_lists.contains(word)) {
          in_uses = false;
        } else if (in_uses) {
          check(word);
        }
      }
    });
  }
  return found;
}

Violations system_headers_stay_in_platform(const Tree& tree) {
  static const std::regex system(
      "(sys|linux|mach|arpa|netinet)/.*|c?signal(\\.h)?|"
      "(unistd|fcntl|dlfcn|windows|pthread|termios|dirent|poll|sched|pwd|io|direct|process|winsock2|spawn)\\."
      "h");
  Violations found;
  for (const Include& include : includes_of(tree, "tools/")) {
    if (folder_below(include.path, "tools/") != "platform" && std::regex_match(include.target, system)) {
      found.push_back(
          violation(include.path, include.line,
                    "<" + include.target + "> belongs to an operating system: ask tools/platform"));
    }
  }
  return found;
}

namespace {

// Every header that a header reaches, itself included, with the place where each is included first.
std::map<std::string, const Include*> reached_from(const std::string& header,
                                                   const std::vector<Include>& includes) {
  std::map<std::string, const Include*> reached{{header, nullptr}};
  std::vector<std::string> waiting{header};
  while (!waiting.empty()) {
    const std::string current = waiting.back();
    waiting.pop_back();
    for (const Include& include : includes) {
      if (include.path != "tools/" + current) continue;
      if (reached.emplace(include.target, &include).second) waiting.push_back(include.target);
    }
  }
  return reached;
}

// Headers under tools/ that a file of another room (or another room's tests) includes.
std::set<std::string> public_headers(const Tree& tree) {
  std::set<std::string> headers;
  for (const std::string_view prefix : {"tools/", "tests/"}) {
    for (const Include& include : includes_of(tree, prefix)) {
      const std::string user = folder_below(include.path, prefix);
      const std::string owner = folder_below(include.target, "");
      if (is_room(owner) && user != owner) headers.insert(include.target);
    }
  }
  return headers;
}

}  // namespace

Violations public_headers_stay_light(const Tree& tree) {
  static const std::regex heavy(
      "(nlohmann|vulkan|glslang|spirv-tools|spirv_cross|embree[34]|assimp|CLI|fmt|tbb|oneapi|EGL|GL)/.*|"
      "stb_.*\\.h|png\\.h|xxhash\\.h");
  const std::vector<Include> includes = includes_of(tree, "tools/");
  Violations found;
  for (const std::string& header : public_headers(tree)) {
    for (const auto& [target, include] : reached_from(header, includes)) {
      if (include == nullptr || include->path == "tools/input/located_json.h") continue;
      if (include->path == "tools/spirv/words.h" && header.starts_with("spirv/")) continue;
      if (std::regex_match(target, heavy)) {
        found.push_back(violation(
            include->path, include->line,
            std::string("<").append(target).append("> reaches every room that includes ").append(header)));
      }
    }
  }
  return found;
}

}  // namespace penumbra::architecture
