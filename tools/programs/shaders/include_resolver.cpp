#include "shaders/include_resolver.h"

#include <algorithm>
#include <utility>

#include "project/include_bounds.h"
#include "shaders/source_memory.h"

namespace penumbra::shaders {

namespace fs = std::filesystem;

namespace {

struct Place {
  int line = 0;
  int column = 0;
};

// Returns the offset of an #include of that name in a line; npos if there is none.
std::size_t column_of_include(std::string_view line, std::string_view asked) {
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return hash;
  const std::size_t word = line.find_first_not_of(" \t", hash + 1);
  if (word == std::string_view::npos || line.substr(word, 7) != "include") return std::string_view::npos;
  return line.find(asked, word);
}

// Returns the first line that includes the name; the file's first line if the name comes from a macro.
Place place_of_include(std::string_view text, std::string_view asked) {
  int number = 0;
  for (std::size_t start = 0; start < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::size_t name = column_of_include(text.substr(start, end - start), asked);
    if (name != std::string_view::npos) return {number + 1, static_cast<int>(name) + 1};
    start = end + 1;
  }
  return {1, 0};
}

project::IncludeRoots roots_of(const CompileRequest& request) {
  project::IncludeRoots roots{
      request.package_roots, request.include_directories, request.project, request.cginc_root, {}, {}};
  const fs::path& owner = request.written_for.value_or(request.file);
  if (!owner.empty()) roots.own.push_back(project::own_tree(owner));
  if (!request.written_for) roots.main_folder = request.file.parent_path();
  return roots;
}

}  // namespace

IncludeResolver::IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources,
                                 SourceMemory& memory)
    : request_(request),
      roots_(roots_of(request)),
      roots_key_(key_of(roots_)),
      sources_(sources),
      memory_(memory),
      open_{request.file.string()} {}

preprocessing::IncludedFile IncludeResolver::enter(const std::string& asked, const std::string& includer) {
  const bool is_nowhere = request_.written_for && includer == request_.file.string();
  const project::IncludeSearch& search =
      memory_.find(roots_, roots_key_, asked, is_nowhere ? std::string() : includer);
  if (!search.file) {
    missing_editor_include_ = search.missing_editor_include;
    return {{}, nullptr, search.problem};
  }
  for (const fs::path& absent : search.absent) absent_.insert(absent.string());
  if (!search.warning.empty()) {
    found_by_case_ = true;
    warn(includer, asked, search.warning);
  }
  std::string name = search.file->string();
  if (std::string problem = open_file(name); !problem.empty()) return {{}, nullptr, std::move(problem)};
  const preprocessing::CutSource& source = memory_.cut(name, request_.prepare);
  return {std::move(name), &source};
}

// Returns the problem; empty if there is none.
std::string IncludeResolver::open_file(const std::string& name) {
  // The file at the depth limit may not be part of the cycle and have a guard: a file of the cycle then
  // follows.
  const bool repeats = std::count(open_.begin(), open_.end(), name) > 1;
  if (open_.size() > (repeats ? max_include_depth : 2 * max_include_depth))
    return "includes nest too deeply: " + chain_to(name);
  if (!sources_.contains(name)) {
    const KnownSource& read = memory_.read(name);
    if (!read.problem.empty()) return "cannot read '" + name + "': " + read.problem;
    sources_.add(name, read.text);
  }
  open_.push_back(name);
  return {};
}

// The warning appears once for each #include, however often its file is read.
void IncludeResolver::warn(const std::string& includer, const std::string& asked,
                           const std::string& problem) {
  const Place place =
      sources_.contains(includer) ? place_of_include(sources_.text(includer), asked) : Place{};
  const bool known = std::any_of(warnings_.begin(), warnings_.end(), [&](const hlsl::Diagnostic& other) {
    return other.file == includer && other.line == place.line && other.message == problem;
  });
  if (known) return;
  warnings_.push_back({includer, place.line, place.column, hlsl::Severity::warning, problem,
                       sources_.line(includer, place.line)});
}

// Returns "a.hlsl -> b.hlsl -> a.hlsl": the shortest tail of the open files that ends where it begins.
std::string IncludeResolver::chain_to(const std::string& name) const {
  auto start = std::find(open_.rbegin(), open_.rend(), name);
  const auto from = start == open_.rend() ? open_.size() - std::min<std::size_t>(open_.size(), 8)
                                          : static_cast<std::size_t>(open_.rend() - start) - 1;
  std::string chain;
  for (std::size_t i = from; i < open_.size(); ++i) chain += open_[i] + " -> ";
  return chain + name;
}

}  // namespace penumbra::shaders
