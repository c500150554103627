#include "shaders/include_resolver.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "input/nearest_name.h"
#include "preparation/source_directives.h"

namespace penumbra::shaders {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view packages = "Packages/";

struct Candidates {
  std::vector<fs::path> files;
  std::string hint;  // said when none of them is there
};

Candidates package_candidates(const CompileRequest& request, const std::string& header) {
  const std::size_t slash = header.find('/', packages.size());
  const std::string package = header.substr(packages.size(), slash - packages.size());
  Candidates candidates;
  std::vector<std::string> known;
  for (const PackageRoot& root : request.package_roots) {
    known.push_back(root.name);
    if (root.name == package && slash != std::string::npos)
      candidates.files.push_back((root.directory / header.substr(slash + 1)).lexically_normal());
  }
  if (candidates.files.empty()) {
    const std::string nearest = nearest_name(package, known);
    candidates.hint = "no package root is given for '" + package + "'" +
                      (nearest.empty() ? "" : "; did you mean '" + nearest + "'?");
  }
  return candidates;
}

// The name of an existing file that is closest to the one asked for, in the folders that were tried.
std::string nearest_file(const std::vector<fs::path>& tried) {
  for (const fs::path& file : tried) {
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

std::string missing_message(const std::string& header, const Candidates& candidates) {
  std::string message = "cannot find '" + header + "'";
  const char* separator = "; tried ";
  for (const fs::path& file : candidates.files) {
    message += separator + file.string();
    separator = ", ";
  }
  if (!candidates.hint.empty()) message += "; " + candidates.hint;
  const std::string nearest = nearest_file(candidates.files);
  if (!nearest.empty()) message += "; did you mean " + nearest + "?";
  return message;
}

}  // namespace

IncludeResolver::IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources)
    : request_(request), sources_(sources), open_{request.file.string()} {}

IncludeResolver::IncludeResult* IncludeResolver::includeLocal(const char* header, const char* includer,
                                                              std::size_t /*depth*/) {
  const std::string asked = header;
  Candidates candidates;
  if (asked.compare(0, packages.size(), packages) == 0) candidates = package_candidates(request_, asked);
  candidates.files.push_back((fs::path(includer).parent_path() / asked).lexically_normal());
  for (const fs::path& directory : request_.include_directories)
    candidates.files.push_back((directory / asked).lexically_normal());
  for (const fs::path& file : candidates.files) {
    std::error_code ignored;
    if (fs::exists(fs::symlink_status(file, ignored))) return open(file.string());
  }
  return fail(missing_message(asked, candidates));
}

// glslang asks here when includeLocal has failed; <...> is looked for as "..." is.
IncludeResolver::IncludeResult* IncludeResolver::includeSystem(const char* header, const char* includer,
                                                               std::size_t depth) {
  return failure_ ? nullptr : includeLocal(header, includer, depth);
}

void IncludeResolver::releaseInclude(IncludeResult* result) {
  if (result == nullptr) return;
  open_.pop_back();
  delete static_cast<std::string*>(result->userData);
  delete result;
}

IncludeResolver::IncludeResult* IncludeResolver::open(const std::string& name) {
  if (open_.size() > max_include_depth) return fail("includes without end: " + chain_to(name));
  if (!sources_.contains(name)) {
    hlsl::SourceRead read = hlsl::read_source(name);
    if (!read.problem.empty()) return fail("cannot read '" + name + "': " + read.problem);
    sources_.add(name, std::move(read.text));
  }
  auto* text = new std::string(with_overlays(name, text_to_read(name)));
  open_.push_back(name);
  return new IncludeResult(name, text->data(), text->size(), text);
}

IncludeResolver::IncludeResult* IncludeResolver::fail(const std::string& problem) {
  if (!failure_) failure_ = problem;
  return nullptr;
}

// The file as the preprocessor is to see it: nothing, the second time that a file says `#pragma once`.
std::string IncludeResolver::text_to_read(const std::string& name) {
  if (!request_.prepare) return sources_.text(name);
  if (read_once_.count(name) != 0) return {};
  preparation::PreparedSource prepared = preparation::prepare_source(sources_.text(name));
  if (prepared.once) read_once_.insert(name);
  return std::move(prepared.text);
}

std::string IncludeResolver::with_overlays(const std::string& name, std::string text) const {
  for (const IncludeOverlay& overlay : request_.overlays) {
    const bool matches =
        name.size() >= overlay.suffix.size() &&
        name.compare(name.size() - overlay.suffix.size(), std::string::npos, overlay.suffix) == 0;
    // An include of its own, so that messages in the overlay name the overlay.
    if (matches) text += "\n#include \"" + fs::absolute(overlay.file).generic_string() + "\"\n";
  }
  return text;
}

// "a.hlsl -> b.hlsl -> a.hlsl": the shortest tail of the open files that closes on itself.
std::string IncludeResolver::chain_to(const std::string& name) const {
  auto start = std::find(open_.rbegin(), open_.rend(), name);
  const auto from = start == open_.rend() ? open_.size() - std::min<std::size_t>(open_.size(), 8)
                                          : static_cast<std::size_t>(open_.rend() - start) - 1;
  std::string chain;
  for (std::size_t i = from; i < open_.size(); ++i) chain += open_[i] + " -> ";
  return chain + name;
}

}  // namespace penumbra::shaders
