#include "project/shader_files.h"

#include <set>
#include <system_error>
#include <utility>

#include "input/ascii_case.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "project/include_bounds.h"
#include "project/json_diagnostic.h"
#include "project/package_manifest.h"

namespace penumbra::project {

namespace {

namespace fs = std::filesystem;

bool has_extension(const fs::path& file, std::string_view extension) {
  return equal_ignoring_case(file.extension().string(), extension);
}

bool is_imported_shader(const fs::path& file) {
  return has_extension(file, ".shader") || has_extension(file, ".compute");
}

// The Unity editor generates shaders from these files.
bool is_graph(const fs::path& file) {
  return has_extension(file, ".shadergraph") || has_extension(file, ".shadersubgraph");
}

constexpr const char* kGraphRemedy =
    "in Unity select the graph, press View Generated Shader in the Inspector, save that text as a .shader "
    "file "
    "in the project and validate that";

hlsl::Diagnostic about_graphs(std::vector<fs::path> graphs) {
  std::sort(graphs.begin(), graphs.end());
  const std::string others = graphs.size() == 1 ? "" : " and " + std::to_string(graphs.size() - 1) + " more";
  return diagnostic_of(graphs.front(), hlsl::Severity::warning,
                       "is a Shader Graph and is not validated" + others + "; " + kGraphRemedy);
}

bool is_hidden(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.empty() || name.front() == '.' || name.back() == '~' || equal_ignoring_case(name, "cvs") ||
         has_extension(path, ".tmp");
}

// Real folders come first, then symbolic links to folders, so that a file that is also reached through a link
// keeps its own path. Links out of the repository or project are not followed.
class ShaderWalk {
 public:
  // Only a folder with a package.json counts in the project's Packages/.
  ShaderWalk(const fs::path& project, std::vector<hlsl::Diagnostic>& problems) : problems_(problems) {
    std::error_code ignored;
    packages_ = fs::canonical(project / "Packages", ignored);
    bounds_.add(project);
  }

  void add(const fs::path& folder) {
    folders_.push_back(folder);
    bounds_.add(own_tree(folder / "Any.shader"));
  }

  std::vector<fs::path> run() {
    while (!folders_.empty() || !links_.empty()) {
      std::vector<fs::path>& next = folders_.empty() ? links_ : folders_;
      const fs::path folder = std::move(next.back());
      next.pop_back();
      enter(folder);
    }
    return std::move(files_);
  }

  const std::vector<fs::path>& graphs() const { return graphs_; }  // valid after run()

 private:
  void enter(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !entered_.insert(real).second) return;
    const bool packages = real == packages_;
    fs::directory_iterator entry(folder, error);
    for (const fs::directory_iterator end; !error && entry != end; entry.increment(error)) {
      if (is_hidden(entry->path())) continue;
      std::error_code ignored;
      if (entry->is_symlink(ignored) && leads_out(*entry)) continue;
      if (!entry->is_directory(ignored)) {
        if (is_imported_shader(entry->path()) && entry->is_regular_file(ignored))
          files_.push_back(entry->path());
        else if (is_imported_shader(entry->path()) && !entry->exists(ignored))
          problems_.push_back(
              diagnostic_of(entry->path(), hlsl::Severity::warning,
                            "is a symbolic link to a file that does not exist, and is skipped"));
        if (is_graph(entry->path())) graphs_.push_back(entry->path());
      } else if (!packages || has_package_manifest(entry->path())) {
        (entry->is_symlink(ignored) ? links_ : folders_).push_back(entry->path());
      }
    }
    if (error)
      problems_.push_back(
          diagnostic_of(folder, hlsl::Severity::warning, "cannot be listed: " + error.message()));
  }

  bool leads_out(const fs::directory_entry& link) {
    std::error_code ignored;
    const bool matters = link.is_directory(ignored) || is_imported_shader(link.path());
    if (!matters || bounds_.contain(link.path())) return false;
    problems_.push_back(diagnostic_of(link.path(), hlsl::Severity::warning,
                                      "is a symbolic link to outside of the project and is skipped; name its "
                                      "target on the command line to validate it"));
    return true;
  }

  std::vector<hlsl::Diagnostic>& problems_;
  IncludeBounds bounds_;
  fs::path packages_;
  std::vector<fs::path> folders_;
  std::vector<fs::path> links_;
  std::set<fs::path> entered_;
  std::vector<fs::path> files_;
  std::vector<fs::path> graphs_;
};

std::string shown_name(const fs::path& file, const fs::path& project) {
  const fs::path relative = project.empty() ? fs::path() : file.lexically_relative(project);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return (below ? relative : file).lexically_normal().generic_string();
}

// Removes the files from the places; the rest are folders to traverse.
void add_place(const fs::path& place, ShaderWalk& walk, std::vector<fs::path>& named) {
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) return walk.add(place);
  if (!fs::exists(place, ignored)) throw InputError(place.string(), "no such file or folder");
  require_shader_file(place);
  named.push_back(place);
}

class Filter {
 public:
  explicit Filter(const ShaderSelection& selection)
      : selection_(selection),
        used_(selection.include.size(), false),
        used_to_skip_(selection.exclude.size(), false) {}

  bool lets_pass(const std::string& shown) {
    seen_.push_back(shown);
    bool included = selection_.include.empty();
    for (std::size_t i = 0; i < selection_.include.size(); ++i)
      if (path_matches(selection_.include[i], shown)) included = used_[i] = true;
    bool excluded = false;
    for (std::size_t i = 0; i < selection_.exclude.size(); ++i)
      if (path_matches(selection_.exclude[i], shown)) excluded = used_to_skip_[i] = true;
    return included && !excluded;
  }

  // Throws with a suggestion for a pattern that matches nothing.
  void require_a_match() const {
    if (used_.empty() || std::find(used_.begin(), used_.end(), true) != used_.end()) return;
    const std::string& pattern = selection_.include.front();
    throw InputError("", "--only '" + pattern + "' matches no shader file", remedy(pattern));
  }

  void report_unused(std::vector<hlsl::Diagnostic>& problems) const {
    const auto report = [&](const std::string& option, const std::string& pattern) {
      problems.push_back(
          {{}, 0, 0, hlsl::Severity::warning, option + " '" + pattern + "' matches no shader file", {}});
    };
    for (std::size_t i = 0; i < selection_.include.size(); ++i)
      if (!used_[i]) report("--only", selection_.include[i]);
    for (std::size_t i = 0; i < selection_.exclude.size(); ++i)
      if (!used_to_skip_[i]) report("--skip", selection_.exclude[i]);
  }

 private:
  std::string remedy(const std::string& pattern) const {
    constexpr std::size_t kMostListed = 5;
    constexpr std::string_view kBelow = "/**";
    std::set<std::string> folders;
    for (const std::string& file : seen_)
      for (std::size_t slash = file.find('/', 1); slash != std::string::npos;
           slash = file.find('/', slash + 1))
        folders.insert(file.substr(0, slash));
    const bool below = pattern.ends_with(kBelow);
    std::vector<std::string> known = seen_;
    if (below) known.assign(folders.begin(), folders.end());
    if (pattern.find('/') == std::string::npos)  // a name alone matches wherever the file is
      for (std::string& file : known) file.erase(0, file.rfind('/') + 1);
    const std::string nearest =
        nearest_name(below ? pattern.substr(0, pattern.size() - kBelow.size()) : pattern, known);
    if (!nearest.empty()) return "did you mean '" + nearest + (below ? std::string(kBelow) : "") + "'?";
    if (seen_.empty()) return "there is no shader file here";
    std::string listed;
    for (std::size_t i = 0; i < std::min(known.size(), kMostListed); ++i)
      listed += (i > 0 ? ", " : "") + known[i] + (below ? std::string(kBelow) : "");
    return "there are: " + listed + (known.size() > kMostListed ? ", ..." : "");
  }

  const ShaderSelection& selection_;
  std::vector<bool> used_;          // one for each pattern of `include`
  std::vector<bool> used_to_skip_;  // one for each pattern of `exclude`
  std::vector<std::string> seen_;   // every file that was tested
};

enum class Kind { character, one, run, long_run, folders };

struct Token {
  Kind kind;
  char character = '\0';
};

std::vector<Token> tokens_of(std::string_view pattern) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '?') {
      tokens.push_back({Kind::one});
    } else if (pattern[i] != '*') {
      tokens.push_back({Kind::character, pattern[i]});
    } else if (pattern.substr(i, 2) != "**") {
      tokens.push_back({Kind::run});
    } else {
      const bool at_start = i == 0 || pattern[i - 1] == '/';
      const bool folders = at_start && pattern.substr(i, 3) == "**/";
      tokens.push_back({folders ? Kind::folders : Kind::long_run});
      i += folders ? 2 : 1;
    }
  }
  return tokens;
}

// The pattern positions (NFA states) that the path read so far can have reached; position i is before token
// i.
class Reached {
 public:
  explicit Reached(const std::vector<Token>& tokens) : tokens_(tokens), places_(tokens.size() + 1, false) {
    enter(places_, 0);
  }

  void read(char c) {
    std::vector<bool> next(places_.size(), false);
    for (std::size_t i = 0; i < tokens_.size(); ++i)
      if (places_[i]) step(i, c, next);
    places_.swap(next);
  }

  bool at_end() const { return places_.back(); }

 private:
  // Tokens that match the empty string are skipped immediately.
  void enter(std::vector<bool>& places, std::size_t i) const {
    for (; !places[i]; ++i) {
      places[i] = true;
      if (i == tokens_.size() || tokens_[i].kind == Kind::character || tokens_[i].kind == Kind::one) return;
    }
  }

  void step(std::size_t i, char c, std::vector<bool>& next) const {
    switch (tokens_[i].kind) {
      case Kind::character:
        if (c == tokens_[i].character) enter(next, i + 1);
        break;
      case Kind::one:
        if (c != '/') enter(next, i + 1);
        break;
      case Kind::run:
        if (c != '/') enter(next, i);
        break;
      case Kind::long_run:
        enter(next, i);
        break;
      case Kind::folders:  // only the end of a folder's name advances
        next[i] = true;
        if (c == '/') enter(next, i + 1);
        break;
    }
  }

  const std::vector<Token>& tokens_;
  std::vector<bool> places_;
};

}  // namespace

void require_shader_file(const fs::path& file) {
  std::error_code ignored;
  IncludeBounds own;
  own.add(own_tree(file));
  if (fs::is_symlink(file, ignored) && fs::exists(file, ignored) && !own.contain(file))
    throw InputError(file.string(), "is a symbolic link to outside of the folder that it belongs to",
                     "name its target to validate it");
  if (is_graph(file))
    throw InputError(file.string(), "is a Shader Graph, from which the Unity editor writes the shader",
                     kGraphRemedy);
  if (!is_imported_shader(file) && !has_extension(file, ".hlsl"))
    throw InputError(file.string(), "is not a shader file",
                     "name a folder, or a .shader, .compute or .hlsl file");
}

ShaderFiles find_shader_files(const fs::path& project, const ShaderSelection& selection) {
  ShaderFiles result;
  ShaderWalk walk(project, result.problems);
  std::vector<fs::path> named;
  for (const fs::path& place : selection.places) add_place(place, walk, named);
  if (selection.places.empty()) {
    for (const char* folder : {"Assets", "Packages"}) {
      std::error_code ignored;
      if (fs::is_directory(project / folder, ignored)) walk.add(project / folder);
    }
  }
  Filter filter(selection);
  for (const fs::path& file : named) {
    std::string shown = shown_name(file, project);
    if (filter.lets_pass(shown))
      result.files.push_back({file, std::move(shown), true});
    else
      result.problems.push_back(diagnostic_of(file, hlsl::Severity::note, "is left out by --only or --skip"));
  }
  for (const fs::path& file : walk.run()) {
    std::string shown = shown_name(file, project);
    if (filter.lets_pass(shown)) result.files.push_back({file, std::move(shown), false});
  }
  std::vector<fs::path> graphs;
  for (const fs::path& graph : walk.graphs())
    if (filter.lets_pass(shown_name(graph, project))) graphs.push_back(graph);
  if (named.empty()) filter.require_a_match();
  filter.report_unused(result.problems);
  if (result.files.empty() && named.empty())
    throw InputError((selection.places.empty() ? project : selection.places.front()).string(),
                     "has no shader file to validate",
                     !graphs.empty() ? std::string("there are Shader Graphs: ") + kGraphRemedy
                                     : "name the folder that holds Assets/ with --project, files, or folders "
                                       "of .shader and .compute files; an "
                                       ".hlsl file is checked by itself where it is named");
  if (!graphs.empty()) result.problems.push_back(about_graphs(std::move(graphs)));
  std::sort(result.files.begin(), result.files.end(),
            [](const ShaderFile& a, const ShaderFile& b) { return a.shown < b.shown; });
  const auto same = [](const ShaderFile& a, const ShaderFile& b) { return a.shown == b.shown; };
  result.files.erase(std::unique(result.files.begin(), result.files.end(), same), result.files.end());
  return result;
}

bool path_matches(std::string_view pattern, std::string_view path) {
  if (pattern.find('/') == std::string_view::npos) path = path.substr(path.rfind('/') + 1);
  const std::vector<Token> tokens = tokens_of(pattern);
  Reached reached(tokens);
  for (const char c : path) reached.read(c);
  return reached.at_end();
}

}  // namespace penumbra::project
