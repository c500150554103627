#include "cli/varied_subjects.h"

#include <fmt/format.h>

#include <iterator>
#include <set>

#include "cli/option_text.h"
#include "cli/option_values.h"
#include "input/file_name.h"
#include "input/input_error.h"
#include "platform/data_directory.h"
#include "study/summary.h"
#include "techniques/technique_list.h"

namespace penumbra::cli {
namespace {

constexpr const char* kDefaultTechnique = "pcss-angular-24-16";

struct Setting {
  std::string parameter;
  double value;
  bool varies;  // the value is one of several
};

struct Parameter {
  std::string technique;  // the technique that alone is varied; empty means each
  std::string name;
  std::vector<double> values;
};

[[noreturn]] void refuse_twice(const std::string& what) {
  throw InputError("", what + " is given twice",
                   "give every adapter a name of its own, and name a parameter once in --set");
}

std::vector<Parameter> parameters(const std::vector<std::string>& set) {
  std::vector<Parameter> parameters;
  std::set<std::string> names;
  for (const std::string& text : set) {
    const auto [name, values] = name_and_value("--set", text);
    if (!names.insert(name).second) refuse_twice("--set " + name);
    const std::size_t colon = name.find(':');
    Parameter parameter{colon == std::string::npos ? "" : name.substr(0, colon),
                        colon == std::string::npos ? name : name.substr(colon + 1),
                        {}};
    if (values.back() == ',') throw InputError("", "--set " + text + ": no value after the last comma");
    for (const std::string& value : split(values, ',')) {
      parameter.values.push_back(number("--set " + name, value));
    }
    drop_repetitions(parameter.values);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

// Returns the parameters of one technique: its own, and those for all techniques that it does not have
// itself.
std::vector<Parameter> parameters_of(const std::string& technique, const std::vector<Parameter>& all) {
  std::vector<Parameter> chosen;
  for (const Parameter& parameter : all) {
    const bool has_its_own = std::any_of(all.begin(), all.end(), [&](const Parameter& other) {
      return other.technique == technique && other.name == parameter.name;
    });
    if (parameter.technique == technique || (parameter.technique.empty() && !has_its_own))
      chosen.push_back(parameter);
  }
  return chosen;
}

void refuse_parameters_of_others(const std::vector<Parameter>& parameters,
                                 const std::vector<std::string>& techniques) {
  for (const Parameter& parameter : parameters)
    if (!parameter.technique.empty() &&
        std::find(techniques.begin(), techniques.end(), parameter.technique) == techniques.end())
      throw InputError("",
                       "--set " + parameter.technique + ":" + parameter.name + ": '" + parameter.technique +
                           "' is not among the techniques",
                       "add --technique " + parameter.technique);
}

// Returns every value of each with every value of the others; the last varies fastest.
std::vector<std::vector<Setting>> combinations(const std::vector<Parameter>& parameters) {
  std::vector<std::vector<Setting>> all{{}};
  for (const Parameter& parameter : parameters) {
    std::vector<std::vector<Setting>> longer;
    for (const std::vector<Setting>& start : all) {
      for (const double value : parameter.values) {
        longer.push_back(start);
        longer.back().push_back({parameter.name, value, parameter.values.size() > 1});
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " " + b;
}

std::string text_of(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings) {
    text = joined(text, fmt::format("{}={}", setting.parameter, setting.value));
  }
  return text;
}

// Names the settings that distinguish a picture from its neighbours; if there are none, all settings.
std::string text_of_varying(const std::vector<Setting>& settings) {
  std::vector<Setting> varying;
  std::copy_if(settings.begin(), settings.end(), std::back_inserter(varying),
               [](const Setting& setting) { return setting.varies; });
  return text_of(varying.empty() ? settings : varying);
}

// A single technique's name would be repeated with every value.
std::string caption(const std::string& title, const std::string& varied, bool alone) {
  return alone ? varied : joined(title, varied);
}

void add_captioned(std::vector<study::Subject>& subjects, const study::Subject& subject,
                   const std::vector<int>& frames, bool alone, const std::string& title,
                   const std::string& varied) {
  if (frames.empty()) {
    subjects.push_back(subject);
    subjects.back().title = caption(title, varied, alone);
  }
  for (const int count : frames) {
    const std::string text = fmt::format("{} frame{}", count, count == 1 ? "" : "s");
    subjects.push_back(subject);
    subjects.back().name = joined(subject.name, text);
    subjects.back().title = caption(title, joined(varied, text), alone);
    subjects.back().averaged_frames = count;
  }
}

// Returns each subject with each of the shares; name and title contain the share where there are several.
std::vector<study::Subject> with_histories(const std::vector<study::Subject>& subjects,
                                           std::vector<double> shares) {
  drop_repetitions(shares);
  if (shares.empty()) return subjects;
  std::vector<study::Subject> all;
  for (const study::Subject& subject : subjects) {
    for (const double share : shares) {
      study::Subject& varied = all.emplace_back(subject);
      varied.history = share;
      if (shares.size() == 1) continue;
      const std::string text = fmt::format("history={:g}", share);
      varied.name = joined(subject.name, text);
      varied.title = joined(subject.title, text);
    }
  }
  return all;
}

std::string name_of(const scene::CascadeBlend& blend) {
  if (blend.border == 0.0) return "none";
  return blend.mixed ? "mix" : "dither";
}

// Dithering is built into the package's own shaders, and so into techniques over the screen.
void require_mixable(const study::Subject& subject, const scene::CascadeBlend& blend) {
  if (!blend.mixed || !subject.graph.graph.over_screen()) return;
  throw InputError("--cascade-blend mix",
                   "'" + subject.name + "' is drawn over the screen, where only dithering is",
                   "choose dither, or techniques that are a filter");
}

struct NamedChoices {
  std::string text;  // the settings that vary; empty if none does
  scene::CascadeChoices choices;
};

// Returns each fit with each blend and each age of the map.
std::vector<NamedChoices> cascade_choices(const std::vector<parameters::LightFit>& fits,
                                          const std::vector<scene::CascadeBlend>& blends,
                                          const std::vector<double>& ages) {
  std::vector<NamedChoices> all;
  for (const parameters::LightFit fit : fits) {
    for (const scene::CascadeBlend& blend : blends) {
      for (const double age : ages) {
        NamedChoices& named = all.emplace_back(NamedChoices{"", {fit, blend, age}});
        if (fits.size() > 1) named.text = fmt::format("light-fit={}", parameters::name_of(fit));
        if (blends.size() > 1) named.text = joined(named.text, "cascade-blend=" + name_of(blend));
        if (ages.size() > 1) named.text = joined(named.text, fmt::format("map-age={:g}", age));
      }
    }
  }
  return all;
}

// Returns each subject with each of the choices; name and title contain the choice where there are several.
std::vector<study::Subject> with_cascades(const std::vector<study::Subject>& subjects,
                                          const std::vector<NamedChoices>& choices) {
  std::vector<study::Subject> all;
  for (const study::Subject& subject : subjects) {
    for (const NamedChoices& named : choices) {
      require_mixable(subject, named.choices.blend);
      study::Subject& varied = all.emplace_back(subject);
      varied.cascade_choices = named.choices;
      varied.name = joined(subject.name, named.text);
      varied.title = joined(subject.title, named.text);
    }
  }
  return all;
}

void refuse_repetitions(const std::vector<study::Subject>& subjects) {
  std::set<std::string> names;
  for (const study::Subject& subject : subjects) {
    if (!names.insert(subject.name).second) refuse_twice("'" + subject.name + "'");
  }
  std::map<std::string, std::string> by_file;
  for (const study::Subject& subject : subjects) {
    const auto [other, is_new] = by_file.emplace(file_name_part(subject.name), subject.name);
    if (!is_new)
      throw InputError(
          "", "the pictures of '" + other->second + "' and '" + subject.name + "' would share a file",
          "name the adapters with letters, digits, '-', '_' and '.' alone");
  }
}

void give_titles(std::vector<study::Subject>& subjects, const std::vector<std::string>& titles) {
  for (const std::string& text : titles) {
    const std::string name = name_and_value("--title", text).first;
    require_plain_name("--title", text);
    // A name with settings contains '='.
    const auto found = std::find_if(subjects.begin(), subjects.end(), [&text](const study::Subject& subject) {
      return text.size() > subject.name.size() + 1 && text.starts_with(subject.name + "=");
    });
    if (found == subjects.end()) {
      std::string names;
      for (const study::Subject& subject : subjects)
        names += (names.empty() ? "'" : ", '") + subject.name + "'";
      throw InputError("", fmt::format("--title {}: no technique or adapter is named '{}'", text, name),
                       "the names are " + names);
    }
    found->title = text.substr(found->name.size() + 1);
  }
}

// The names of all techniques for the sun replace `all`.
std::vector<std::string> without_all(const std::vector<std::string>& given,
                                     const techniques::TechniqueList& list) {
  std::vector<std::string> names;
  for (const std::string& name : given) {
    if (name != kAll) names.push_back(name);
    if (name != kAll) continue;
    for (const techniques::Technique& technique : list.techniques)
      if (technique.is_for(techniques::LightKind::directional)) names.push_back(technique.name);
  }
  return names;
}

// The techniques of the list that was given and, by their names, the library's own, for comparison.
class KnownTechniques {
 public:
  explicit KnownTechniques(const std::string& technique_list)
      : given_(chosen_technique_list(technique_list)) {
    if (!technique_list.empty()) library_ = techniques::read_own_techniques();
  }

  const techniques::TechniqueList& given() const { return given_; }

  // Returns the list that has the technique; the given one, if none has.
  const techniques::TechniqueList& list_of(const std::string& name) const {
    const auto has = [&](const techniques::TechniqueList& list) {
      const auto is_named = [&](const techniques::Technique& technique) { return technique.name == name; };
      return std::any_of(list.techniques.begin(), list.techniques.end(), is_named);
    };
    return library_ && !has(given_) && has(*library_) ? *library_ : given_;
  }

 private:
  techniques::TechniqueList given_;
  std::optional<techniques::TechniqueList> library_;
};

}  // namespace

void add_set_option(CLI::App& command, const std::string& group, VariedSubjects& varied) {
  one_each(
      command.add_option("--set", varied.set,
                         "A parameter of the techniques, or of one of them; several values are tried one "
                         "by one"))
      ->type_name("[TECHNIQUE:]NAME=VALUE[,...]")
      ->default_str("each technique's own values")
      ->group(group);
}

void add_title_option(CLI::App& command, const std::string& group, VariedSubjects& varied) {
  one_each(
      command.add_option("--title", varied.titles, "Title of a technique or adapter, in captions and tables"))
      ->type_name("NAME=TEXT")
      ->default_str("its own")
      ->group(group);
}

std::vector<study::Subject> varied_subjects(const StudyOptions& options, const VariedSubjects& varied) {
  const bool reversed_z = options.reversed_z;
  const KnownTechniques known(options.technique_list);
  std::vector<std::string> names = without_all(options.techniques, known.given());
  drop_repetitions(names);
  std::vector<int> frames = varied.frames;
  drop_repetitions(frames);
  if (names.empty() && options.adapters.empty())
    names.push_back(options.technique_list.empty() ? kDefaultTechnique : known.given().first().name);
  if (names.empty() && !varied.set.empty()) {
    throw InputError("", "--set applies to techniques, and only adapters are given",
                     "set an adapter's uniforms with --adapter 'NAME=FILE;UNIFORM=a,b,c,d'");
  }
  const std::vector<Parameter> set = parameters(varied.set);
  refuse_parameters_of_others(set, names);
  const std::vector<resolve::Adapter> adapters = chosen_adapters(options);
  const bool varies = std::any_of(set.begin(), set.end(),
                                  [](const Parameter& parameter) { return parameter.values.size() > 1; });
  const bool alone = names.size() + adapters.size() == 1 && (varies || varied.frames.size() > 1);

  std::vector<study::Subject> subjects;
  for (const std::string& name : names) {
    const techniques::TechniqueList& list = known.list_of(name);
    for (const std::vector<Setting>& combination : combinations(parameters_of(name, set))) {
      techniques::Technique technique = list.find(name);
      for (const Setting& setting : combination) {
        technique = techniques::with_value(list, std::move(technique), setting.parameter, setting.value);
      }
      study::Subject subject = study::technique_subject(list, technique, reversed_z);
      choose_bias(options, subject);
      subject.name = joined(name, text_of(combination));
      const std::string title = study::short_title(name, subject.title);
      if (!combination.empty()) subject.title = joined(title, text_of(combination));
      if (varied.captions)
        add_captioned(subjects, subject, frames, alone, title, text_of_varying(combination));
      else
        subjects.push_back(std::move(subject));
    }
  }
  const std::vector<parameters::LightFit> fits = chosen_light_fits(options);
  std::vector<double> ages = options.map_ages;
  drop_repetitions(ages);
  subjects = with_cascades(subjects, cascade_choices(fits, chosen_cascade_blends(options), ages));
  std::vector<study::Subject> of_adapters;
  for (const resolve::Adapter& adapter : adapters) {
    study::Subject subject = study::adapter_subject(adapter, reversed_z);
    choose_bias(options, subject);
    if (varied.captions)
      add_captioned(of_adapters, subject, frames, alone, study::short_title(adapter.name, subject.title), "");
    else
      of_adapters.push_back(std::move(subject));
  }
  const std::vector<scene::CascadeBlend> unblended(1);  // these subjects choose cascades themselves
  of_adapters = with_cascades(of_adapters, cascade_choices(fits, unblended, ages));
  subjects.insert(varied.adapters == "first" ? subjects.begin() : subjects.end(), of_adapters.begin(),
                  of_adapters.end());
  subjects = with_histories(subjects, varied.histories);
  refuse_repetitions(subjects);
  give_titles(subjects, varied.titles);
  return subjects;
}

}  // namespace penumbra::cli
