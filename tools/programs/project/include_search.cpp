#include "project/include_search.h"

#include <system_error>
#include <utility>

#include "input/ascii_case.h"
#include "input/nearest_name.h"
#include "project/editor_includes.h"
#include "project/folder_entries.h"
#include "project/include_bounds.h"

namespace penumbra::project {

namespace {

namespace fs = std::filesystem;

// More occur only on maliciously prepared disks; two are already ambiguous.
constexpr std::size_t most_paths = 8;

void add_matches(const fs::path& folder, const std::string& name, std::vector<fs::path>& found) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string entry_name = entry->path().filename().string();
    if (equal_ignoring_case(entry_name, name)) found.push_back(folder / entry_name);
  }
}

// Case-insensitive file lookup, as on the file systems of Windows and macOS (ASCII letters only). Internal to
// this folder.
//
// Returns every file whose path below `base` is `rest` up to case, sorted; at most a handful. `base` itself
// is case-sensitive.
std::vector<fs::path> files_ignoring_case(const fs::path& base, const fs::path& rest) {
  std::vector<fs::path> paths{base};
  for (const fs::path& component : rest) {
    std::vector<fs::path> next;
    for (const fs::path& folder : paths) {
      if (component == "." || component == "..")
        next.push_back(folder / component);
      else
        add_matches(folder, component.string(), next);
    }
    std::sort(next.begin(), next.end());
    if (next.size() > most_paths) next.resize(most_paths);
    paths = std::move(next);
  }
  return rest.empty() ? std::vector<fs::path>() : paths;
}

constexpr std::string_view packages = "Packages/";
constexpr std::string_view assets = "Assets/";

// A candidate location: `rest` below a folder whose own spelling is correct.
struct Place {
  fs::path base;
  fs::path rest;
  fs::path file() const { return (base / rest).lexically_normal(); }
};

struct Places {
  std::vector<Place> tried;
  std::vector<Place> other_case;  // a package or folder that differs in case from the requested one
  std::string hint;               // reported if the file is not found
};

bool starts_with_ignoring_case(std::string_view text, std::string_view start) {
  return text.size() >= start.size() && equal_ignoring_case(text.substr(0, start.size()), start);
}

// Returns the path with slashes for backslashes, without doubled slashes, "./", and "../" after a folder.
std::string normalised(std::string_view asked) {
  std::string text(asked);
  std::replace(text.begin(), text.end(), '\\', '/');
  return fs::path(text).lexically_normal().generic_string();
}

void add_package_places(const IncludeRoots& roots, const std::string& header, Places& places) {
  const std::size_t slash = header.find('/', packages.size());
  const std::string with_version = header.substr(packages.size(), slash - packages.size());
  const std::string package = with_version.substr(0, with_version.find('@', 1));
  const bool exact = header.compare(0, packages.size(), packages) == 0;
  std::vector<std::string> known;
  bool found = false;
  for (const PackageRoot& root : roots.packages) {
    known.push_back(root.name);
    if (slash == std::string::npos || !equal_ignoring_case(root.name, package)) continue;
    found = true;
    const Place place{root.directory, header.substr(slash + 1)};
    (exact && root.name == package ? places.tried : places.other_case).push_back(place);
  }
  if (found) return;
  const std::string nearest = nearest_name(package, known);
  places.hint =
      "no package root is given for '" + package + "'" +
      (nearest.empty() ? "; give --package-root " + package + "=DIR, or --project DIR of a Unity project"
                       : "; did you mean '" + nearest + "'?");
}

void add_asset_places(const IncludeRoots& roots, const std::string& header, Places& places) {
  if (roots.project.empty()) {
    places.hint = "name the folder that contains Assets/ with --project DIR";
    return;
  }
  places.tried.push_back({roots.project, header});
}

Places places_of(const IncludeRoots& roots, const std::string& header, const fs::path& includer) {
  Places places;
  if (starts_with_ignoring_case(header, packages)) add_package_places(roots, header, places);
  if (starts_with_ignoring_case(header, assets)) add_asset_places(roots, header, places);
  std::vector<fs::path> beside;
  if (!includer.empty()) beside.push_back(includer.parent_path());
  if (!roots.main_folder.empty() && (beside.empty() || roots.main_folder != beside[0]))
    beside.push_back(roots.main_folder);
  // A path such as "/Include/A.hlsl" is beside the includer, unless the disk's root has it.
  const std::size_t after_slashes = header.find_first_not_of('/');
  for (const fs::path& folder : beside) {
    places.tried.push_back({folder, header});
    if (after_slashes != 0 && after_slashes != std::string::npos)
      places.tried.push_back({folder, header.substr(after_slashes)});
  }
  for (const fs::path& directory : roots.directories) places.tried.push_back({directory, header});
  return places;
}

std::string ambiguous_message(std::string_view asked, const std::vector<fs::path>& files) {
  std::string list;
  for (const fs::path& file : files) list += (list.empty() ? "" : ", ") + file.string();
  return "cannot find '" + std::string(asked) + "'; more than one file differs from it only in case: " + list;
}

IncludeBounds bounds_of(const IncludeRoots& roots) {
  IncludeBounds bounds;
  for (const fs::path& folder : roots.directories) bounds.add(folder);
  for (const PackageRoot& package : roots.packages) bounds.add(package.directory);
  for (const fs::path& folder : roots.own) bounds.add(folder);
  bounds.add(roots.project);
  bounds.add(roots.cginc);
  return bounds;
}

// Finds files that differ from the requested one only in case, at the first place that has one.
bool find_other_case(const Places& places, std::string_view asked, const IncludeBounds& bounds,
                     IncludeSearch& search) {
  std::vector<Place> all = places.other_case;
  all.insert(all.end(), places.tried.begin(), places.tried.end());
  for (const Place& place : all) {
    std::vector<fs::path> files = files_ignoring_case(place.base, place.rest);
    std::erase_if(files, [&](const fs::path& file) { return !bounds.contain(file); });
    if (files.empty()) continue;
    if (files.size() > 1) {
      search.problem = ambiguous_message(asked, files);
      return true;
    }
    search.file = files.front().lexically_normal();
    search.warning = "'" + std::string(asked) + "' names " + search.file->string() +
                     " in another case; only disks that ignore case find it";
    return true;
  }
  return false;
}

// Returns the name of an existing file that is closest to the requested one, in the folders that were tried.
std::string nearest_file(const std::vector<Place>& tried, const IncludeBounds& bounds) {
  for (const Place& place : tried) {
    const fs::path file = place.file();
    if (!bounds.contain(file.parent_path())) continue;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(file.parent_path().empty() ? "." : file.parent_path(), error), end;
         !error && entry != end; entry.increment(error))
      names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::string nearest = nearest_name(file.filename().string(), names);
    if (!nearest.empty()) return (file.parent_path() / nearest).string();
  }
  return {};
}

// The message is the same whether or not the file exists.
std::string outside_message(std::string_view asked, const fs::path& file) {
  std::error_code error;
  const bool linked = fs::weakly_canonical(file, error) != fs::absolute(file, error).lexically_normal();
  const std::string to = linked ? "through a symbolic link" : "to " + file.string() + ",";
  return "'" + std::string(asked) + "' leads " + to +
         " outside of the project, the packages, the include folders and the shader's own repository or "
         "folder; if it may be read, name its folder as an include folder (-I DIR of validate and cost)";
}

std::string missing_message(std::string_view asked, const Places& places, const IncludeBounds& bounds) {
  std::string message = "cannot find '" + std::string(asked) + "'";
  std::vector<Place> tried = places.other_case;
  tried.insert(tried.end(), places.tried.begin(), places.tried.end());
  std::vector<std::string> named;  // an include directory may be the includer's own folder
  for (const Place& place : tried) {
    const std::string file = place.file().string();
    if (std::find(named.begin(), named.end(), file) != named.end()) continue;
    message += (named.empty() ? "; tried " : ", ") + file;
    named.push_back(file);
  }
  if (!places.hint.empty()) message += "; " + places.hint;
  const std::string nearest = nearest_file(tried, bounds);
  if (!nearest.empty()) message += "; did you mean " + nearest + "?";
  return message;
}

std::string missing_editor_message(std::string_view name, const fs::path& cginc) {
  const std::string start = "cannot find '" + std::string(name) + "'";
  const std::string ships = "it ships only with the Unity editor (Editor/Data/CGIncludes)";
  if (cginc.empty()) return start + ": " + ships + "; name that folder with --cginc-root DIR";
  return start + " in " + cginc.string() + ", which --cginc-root names: " + ships +
         "; is this the folder of an editor that has it?";
}

}  // namespace

IncludeSearch find_include(const IncludeRoots& roots, std::string_view asked, const fs::path& includer) {
  std::string header = normalised(asked);
  // Unity finds these in the project, as it does without the first '/'.
  if (header.starts_with("/Assets/") || header.starts_with("/Packages/")) header.erase(0, 1);
  if (header.empty()) {
    IncludeSearch nothing;
    nothing.problem = "the #include names no file";
    return nothing;
  }
  Places places = places_of(roots, header, includer);
  const std::string_view editor_name = editor_include(header);
  if (!roots.cginc.empty()) places.tried.push_back({roots.cginc, header});
  const IncludeBounds bounds = bounds_of(roots);
  IncludeSearch search;
  std::optional<fs::path> outside;
  for (const Place& place : places.tried) {
    const fs::path file = place.file();
    if (!bounds.contain(file)) {
      if (!outside) outside = file;
      continue;
    }
    if (is_there(file)) {
      search.file = file;
      return search;
    }
    search.absent.push_back(file);
  }
  if (find_other_case(places, asked, bounds, search)) return search;
  search.missing_editor_include = editor_name;
  if (!editor_name.empty())
    search.problem = missing_editor_message(editor_name, roots.cginc);
  else
    search.problem = outside ? outside_message(asked, *outside) : missing_message(asked, places, bounds);
  return search;
}

}  // namespace penumbra::project
