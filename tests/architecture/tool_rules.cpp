#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <sstream>

#include "architecture/rules.h"
#include "architecture/source_lines.h"

namespace penumbra::architecture {
namespace {

struct Room {
  std::string_view name;
  std::string_view group;  // its folder in tools/; empty: it stands in tools/ itself
};

// Each room may include those behind it.
constexpr std::array<Room, 24> kRooms{{{"cli", ""},
                                       {"study", "measurement"},
                                       {"lighting", "measurement"},
                                       {"bake", "measurement"},
                                       {"reference", "measurement"},
                                       {"resolve", "measurement"},
                                       {"scene", "measurement"},
                                       {"cost", "checking"},
                                       {"validation", "checking"},
                                       {"lint", "checking"},
                                       {"gpu", "programs"},
                                       {"techniques", "programs"},
                                       {"shaders", "programs"},
                                       {"preparation", "programs"},
                                       {"variants", "programs"},
                                       {"shaderlab", "programs"},
                                       {"project", "programs"},
                                       {"fxc", "programs"},
                                       {"preprocessing", "programs"},
                                       {"hlsl", "programs"},
                                       {"spirv", "programs"},
                                       {"parameters", "base"},
                                       {"platform", "base"},
                                       {"input", "base"}}};

std::size_t place_of(std::string_view room) {
  return static_cast<std::size_t>(
      std::find_if(kRooms.begin(), kRooms.end(), [&](const Room& each) { return each.name == room; }) -
      kRooms.begin());
}

bool is_room(std::string_view name) {
  return place_of(name) < kRooms.size();
}

std::string_view group_of(std::string_view room) {
  return kRooms[place_of(room)].group;
}

bool is_group(std::string_view name) {
  return std::any_of(kRooms.begin(), kRooms.end(), [&](const Room& room) { return room.group == name; });
}

// The path as includes name it: "tools/measurement/scene/frame.cpp" gives "scene/frame.cpp". Empty outside of
// tools/.
std::string included_as(std::string_view path) {
  constexpr std::string_view tools = "tools/";
  if (!path.starts_with(tools)) return {};
  path.remove_prefix(tools.size());
  const std::string first = folder_below(path, "");
  if (!first.empty() && is_group(first)) path.remove_prefix(first.size() + 1);
  return std::string(path);
}

std::string room_of(std::string_view path) {
  return folder_below(included_as(path), "");
}

bool is_in_its_group(std::string_view path, std::string_view room) {
  const std::string folder = folder_below(path, "tools/");
  return folder == (group_of(room).empty() ? room : group_of(room));
}

bool may_use(std::string_view user, std::string_view used) {
  if (user == used) return true;
  if (group_of(user) == "measurement" && group_of(used) == "checking") return false;
  if (used == "parameters" && (group_of(user) == "checking" || group_of(user) == "programs")) return false;
  return place_of(user) < place_of(used);
}

}  // namespace

Violations tool_includes_point_down(const Tree& tree) {
  Violations found;
  for (const Include& include : includes_of(tree, "tools/")) {
    const std::string user = room_of(include.path);
    const std::string used = folder_below(include.target, "");
    if (used == "..") {
      found.push_back(violation(include.path, include.line, "names a room by '..'; name it from tools/"));
    }
    if (!user.empty() && !is_room(user)) {
      found.push_back(
          violation(include.path, include.line, "'" + user + "' has no place in the order of rooms"));
    } else if (!user.empty() && !is_in_its_group(include.path, user)) {
      found.push_back(
          violation(include.path, include.line, user + " belongs into tools/" + std::string(group_of(user))));
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
    const std::string user = room_of(path);
    if (user.empty() || included_as(path) != user + "/CMakeLists.txt") continue;
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
    if (room_of(include.path) != "platform" && std::regex_match(include.target, system)) {
      found.push_back(
          violation(include.path, include.line,
                    "<" + include.target + "> belongs to an operating system: ask tools/base/platform"));
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
      if (included_as(include.path) != current) continue;
      if (reached.emplace(include.target, &include).second) waiting.push_back(include.target);
    }
  }
  return reached;
}

// The headers under tools/ that a file of another room (or another room's tests) includes.
std::set<std::string> public_headers(const Tree& tree) {
  std::set<std::string> headers;
  for (const std::string_view prefix : {"tools/", "tests/"}) {
    for (const Include& include : includes_of(tree, prefix)) {
      const std::string user =
          prefix == "tools/" ? room_of(include.path) : folder_below(include.path, prefix);
      const std::string owner = folder_below(include.target, "");
      if (is_room(owner) && user != owner) headers.insert(include.target);
    }
  }
  return headers;
}

}  // namespace

Violations public_headers_stay_light(const Tree& tree) {
  static const std::regex heavy(
      "(nlohmann|vulkan|glslang|spirv-tools|spirv_cross|embree[34]|assimp|CLI|fmt|oneapi|EGL|GL)/.*|"
      "stb_.*\\.h|png\\.h|blake2\\.h");
  const std::vector<Include> includes = includes_of(tree, "tools/");
  Violations found;
  for (const std::string& header : public_headers(tree)) {
    for (const auto& [target, include] : reached_from(header, includes)) {
      if (include == nullptr || include->path == "tools/base/input/located_json.h") continue;
      if (include->path == "tools/programs/spirv/words.h" && header.starts_with("spirv/")) continue;
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
