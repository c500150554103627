#include "cli/known_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/subcommand.h"
#include "cost/families.h"
#include "fxc/fxc.h"
#include "lint/rule.h"
#include "platform/data_directory.h"
#include "scene/scene.h"
#include "shaders/cross_compile.h"
#include "techniques/technique_list.h"
#include "validation/spirv_target.h"

namespace penumbra::cli {
namespace {

struct KnownName {
  std::string name;
  std::string description;  // may be empty
};

std::vector<KnownName> scenes() {
  std::vector<KnownName> names;
  for (const std::string& name : scene::all_built_in_names())
    names.push_back({name, scene::built_in_description(name)});
  for (const scene::PackageModel& model : scene::package_models())
    names.push_back(
        {"package:" + model.name, model.description + ", from the Debian package " + model.debian_package});
  return names;
}

std::vector<KnownName> names_in(const techniques::TechniqueList& list) {
  std::vector<KnownName> names;
  for (const techniques::Technique& technique : list.techniques)
    names.push_back({technique.name, technique.title});
  return names;
}

std::vector<KnownName> techniques() {
  return names_in(techniques::read_own_techniques());
}

std::vector<KnownName> families() {
  std::vector<KnownName> names;
  for (const cost::KnownFamily& family : cost::known_families())
    names.push_back({family.name, family.architecture});
  if (fxc::find_fxc().found)
    names.push_back({cost::direct3d_family.name, cost::direct3d_family.architecture});
  return names;
}

std::vector<KnownName> targets() {
  std::vector<KnownName> names;
  for (const std::string& name : validation::spirv_targets()) names.push_back({name, ""});
  names.push_back({std::string(validation::fxc_target), "FXC, Unity's compiler"});
  for (const shaders::Target target : shaders::all_targets)
    names.push_back({std::string(shaders::target_name(target)), ""});
  return names;
}

std::vector<KnownName> rules() {
  std::vector<KnownName> names;
  for (const lint::RuleInfo& rule : lint::rules()) names.push_back({rule.name, rule.summary});
  return names;
}

struct NameKind {
  const char* placeholder;  // shown in help for the options that take such a name
  const char* flag;         // the option that prints them
  std::vector<KnownName> (*names)();
};

constexpr NameKind kKinds[] = {{"SCENE", "--list-scenes", scenes},
                               {"TECHNIQUE", "--list-techniques", techniques},
                               {"FAMILY", "--list-families", families},
                               {"TARGET", "--list-targets", targets},
                               {"RULE", "--list-rules", rules}};

const NameKind& kind_of(const std::string& placeholder) {
  for (const NameKind& kind : kKinds)
    if (kind.placeholder == placeholder) return kind;
  throw std::out_of_range("unknown kind of name " + placeholder);
}

// Returns the names that the command takes with the options given.
std::vector<KnownName> names_of(const NameKind& kind, const CLI::App& command) {
  // The list of families depends on whether FXC is found.
  const CLI::Option* location = command.get_option_no_throw("--fxc");
  if (location != nullptr && !location->empty()) fxc::choose_fxc(location->results().front());
  const CLI::Option* list = command.get_option_no_throw("--technique-list");
  const bool takes_place = kind.names == techniques && list != nullptr && !list->empty();
  return takes_place ? names_in(techniques::read_technique_list(list->results().front())) : kind.names();
}

void print(const std::vector<KnownName>& names) {
  std::size_t width = 0;
  for (const KnownName& known : names) width = std::max(width, known.name.size());
  std::string text;
  for (const KnownName& known : names) {
    text += known.description.empty() ? known.name
                                      : fmt::format("{:{}}  {}", known.name, width, known.description);
    text += '\n';
  }
  write_output("", text);
}

}  // namespace

void takes(CLI::App& command, CLI::Option* option, const char* placeholder) {
  const NameKind& kind = kind_of(placeholder);
  option->type_name(placeholder);
  if (command.get_option_no_throw(kind.flag) != nullptr) return;
  const auto print_and_end = [&kind, &command] {
    print(names_of(kind, command));
    throw CLI::Success();
  };
  command.add_flag_callback(kind.flag, print_and_end, fmt::format("Print every {} and exit", placeholder))
      ->group(option->get_group());
}

}  // namespace penumbra::cli
