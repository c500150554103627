#include "cli/usage_error.h"

#include <algorithm>
#include <regex>
#include <utility>
#include <vector>

#include "cli/command_line.h"
#include "input/nearest_name.h"

namespace penumbra::cli {
namespace {

// These are names that other programs, or other subcommands of this one, use for an option. Of several, the
// first that the subcommand has is suggested.
constexpr std::pair<const char*, const char*> kOtherNames[] = {
    {"report", "format"},
    {"form", "format"},
    {"out", "output"},
    {"folder", "output"},
    {"angle", "light"},
    {"diameter", "light"},
    {"resolution", "map-size"},
    {"resolution", "size"},
    {"shadow-distance", "distance"},
    {"threads", "jobs"},
    {"parallel", "jobs"},
    {"conventional-z", "reversed-z"},
    {"techniques", "technique"},
    {"techniques", "technique-list"},
    {"keywords", "keyword-set"},
    {"list", "count"},
    {"list", "list-techniques"},
    {"dry-run", "count"},
    {"samples", "reference-samples"},
    {"silent", "quiet"},
};

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-' && argument != "--";
}

std::vector<std::string> long_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
    for (const CLI::Option* option : app->get_options())
      names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

std::string nearest_option(const CLI::App& command, const std::string& given) {
  const std::vector<std::string> known = long_names(command);
  const auto has = [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (const auto& [other, ours] : kOtherNames)
    if (given == other && has(ours)) return ours;
  return nearest_name(given, known);
}

std::string called(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name() : "penumbra " + command.get_name();
}

std::string lines(const std::string& first, const std::string& second) {
  return first.empty() ? second : first + "\n  " + second;
}

std::string see_help(const CLI::App& command) {
  return "see: " + called(command) + " --help";
}

InputError unknown_option(const CLI::App& command, const std::string& argument) {
  const std::string typed = argument.substr(0, argument.find('='));
  std::string nearest;
  if (typed.starts_with("--")) nearest = nearest_option(command, typed.substr(2));
  return {"", called(command) + " has no option '" + typed + "'",
          lines(nearest.empty() ? "" : "did you mean '--" + nearest + "'?", see_help(command))};
}

InputError too_many(const CLI::App& command, const std::string& argument) {
  return {"", called(command) + " does not expect '" + argument + "'", see_help(command)};
}

// CLI11's messages, rewritten in this program's terms.
std::string plain_words(const std::string& said) {
  static const std::pair<std::regex, const char*> kWords[] = {
      {std::regex("^(\\S+): is empty$"), "$1 is empty"},
      {std::regex("^(\\S+): At Most 1 required but received 2$"), "$1 is given twice"},
      {std::regex("^(\\S+): At Most 1 required but received (\\d+)$"), "$1 is given $2 times"},
      {std::regex("^(\\S+): At Most (\\d+) required but received (\\d+)$"),
       "$1 takes at most $2 numbers, not $3"},
      {std::regex("^(\\S+): At least (\\d+) required but received (\\d+)$"),
       "$1 takes at least $2 numbers, not $3"},
      {std::regex("^(\\S+): \\d+ required (.+) missing$"), "$1 is given without its $2"},
      {std::regex("^Could not convert: (\\S+) = (.*)$"), "$1 does not take the value '$2'"},
      {std::regex("^(\\S+) requires (\\S+)$"), "$1 needs $2"},
  };
  for (const auto& [theirs, ours] : kWords)
    if (std::regex_match(said, theirs)) return std::regex_replace(said, theirs, ours);
  return said;
}

}  // namespace

InputError unknown_subcommand(CLI::App& app, const std::string& name) {
  std::vector<std::string> known;
  for (const CLI::App* command : shown_subcommands(app)) known.push_back(command->get_name());
  return {"", "unknown subcommand '" + name + "'", lines(unknown_name_remedy(name, known), see_help(app))};
}

InputError usage_error(CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::vector<std::string> unexpected = app.remaining(true);
  const auto option = std::find_if(unexpected.begin(), unexpected.end(), is_option);
  if (chosen.empty() && !unexpected.empty() && option != unexpected.begin())
    return unknown_subcommand(app, unexpected.front());
  if (option != unexpected.end()) return unknown_option(command, *option);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unexpected.empty())
    return too_many(command, unexpected.front());
  const std::string said = plain_words(error.what());  // the message's own way out follows on further lines
  const std::size_t end = std::min(said.find("\n  "), said.size());
  return {"", said.substr(0, end), lines(end < said.size() ? said.substr(end + 3) : "", see_help(command))};
}

}  // namespace penumbra::cli
