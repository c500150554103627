#include "variants/keyword_space.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "variants/keyword_join.h"
#include "variants/pragma_names.h"

namespace penumbra::variants {
namespace {

bool has_any(const Keywords& alternative, const Keywords& keywords) {
  return std::any_of(alternative.begin(), alternative.end(),
                     [&](const std::string& keyword) { return contains(keywords, keyword); });
}

bool can_be_off(const KeywordSet& set) {
  return std::any_of(set.alternatives.begin(), set.alternatives.end(),
                     [](const Keywords& alternative) { return alternative.empty(); });
}

void drop_repeated(std::vector<Choice>& choices) {
  std::set<Choice> seen;
  std::erase_if(choices, [&](const Choice& choice) { return !seen.insert(choice).second; });
}

std::vector<KeywordSet> declared_sets(const Pragmas& pragmas, const Narrowing& narrowing) {
  std::vector<KeywordSet> sets = pragmas.keyword_sets;
  const Place program{pragmas.files.empty() ? "" : pragmas.files.front(), 1, 1};
  if (!narrowing.stereo_modes.empty()) {
    sets.push_back(stereo_set(narrowing.stereo_modes));
    sets.back().place = program;
  }
  if (contains(pragmas.tier_renderers, narrowing.tiers_for)) {
    KeywordSet tiers;
    tiers.pragma = "hardware_tier_variants";
    tiers.alternatives = {{"UNITY_HARDWARE_TIER1"}, {"UNITY_HARDWARE_TIER2"}, {"UNITY_HARDWARE_TIER3"}};
    tiers.place = program;
    sets.push_back(std::move(tiers));
  }
  return sets;
}

// Applies the clauses that look at one set at a time and keeps the others, which tie sets together.
class Narrower {
 public:
  explicit Narrower(std::vector<KeywordSet>& sets) : sets_(sets) {
    for (std::size_t i = 0; i < sets.size(); ++i)
      for (const std::string& keyword : keywords_of(sets[i])) sets_with_[keyword].push_back(i);
  }

  void apply(const std::vector<Clause>& clauses) {
    std::map<std::string, const Clause*> never;
    for (const Clause& clause : clauses) {
      if (clause.when.empty()) {
        demand(clause);
      } else if (clause.any_of.empty()) {
        never.emplace(clause.when, &clause);
      } else {
        tying.push_back(clause);
      }
    }
    const Clause* last = nullptr;
    const auto forbidden = [&](const std::string& keyword) {
      const auto found = never.find(keyword);
      if (found != never.end()) last = found->second;
      return found != never.end();
    };
    for (KeywordSet& set : sets_) {
      keep(set, [&](const Keywords& alternative) {
        return std::none_of(alternative.begin(), alternative.end(), forbidden);
      });
      if (set.alternatives.empty() && last != nullptr && emptied_by.empty()) emptied_by = last->said_by;
    }
  }

  std::vector<Clause> tying;
  std::string emptied_by;

 private:
  template <typename Wanted>
  static void keep(KeywordSet& set, Wanted wanted) {
    std::erase_if(set.alternatives, [&](const Keywords& alternative) { return !wanted(alternative); });
  }

  void demand(const Clause& clause) {
    std::set<std::size_t> holders;
    for (const std::string& keyword : clause.any_of) {
      const auto found = sets_with_.find(keyword);
      if (found != sets_with_.end()) holders.insert(found->second.begin(), found->second.end());
      if (found == sets_with_.end() && clause.whole) return;
    }
    if (!clause.of_their_sets && holders.size() > 1) {
      tying.push_back(clause);
      return;
    }
    for (const std::size_t holder : holders) {
      KeywordSet& set = sets_[holder];
      keep(set, [&](const Keywords& alternative) {
        return has_any(alternative, clause.any_of) || (clause.or_none && alternative.empty());
      });
      if (set.alternatives.empty() && emptied_by.empty()) emptied_by = clause.said_by;
    }
  }

  std::vector<KeywordSet>& sets_;
  std::map<std::string, std::vector<std::size_t>> sets_with_;
};

// Returns the alternative of a shader_feature set that a material with these keywords uses.
const Keywords& used_by(const Keywords& material, const KeywordSet& set) {
  const Keywords* fallback = &set.alternatives.front();
  for (const Keywords& alternative : set.alternatives) {
    const bool on = std::all_of(alternative.begin(), alternative.end(),
                                [&](const std::string& keyword) { return contains(material, keyword); });
    if (on && !alternative.empty()) return alternative;
    if (alternative.empty()) fallback = &alternative;
  }
  return *fallback;
}

class Numbering {
 public:
  int number_of(const std::string& keyword) {
    const auto [found, is_new] = numbers_.try_emplace(keyword, static_cast<int>(names_.size()));
    if (is_new) names_.push_back(keyword);
    return found->second;
  }
  Choice choice_of(const Keywords& alternative) {
    Choice choice;
    for (const std::string& keyword : alternative) choice.push_back(number_of(keyword));
    std::sort(choice.begin(), choice.end());
    return choice;
  }
  const Keywords& names() const { return names_; }

 private:
  std::map<std::string, int> numbers_;
  Keywords names_;
};

bool is_by_material(const KeywordSet& set, const Narrowing& narrowing) {
  return narrowing.materials &&
         (narrowing.materials_decide_all || set.kind == KeywordSet::Kind::shader_feature);
}

// Joins the sets that materials decide into one: an alternative for each distinct material.
JoinedSet material_set(const std::vector<KeywordSet>& sets, const Narrowing& narrowing,
                       Numbering& numbering) {
  JoinedSet joined;
  std::vector<Keywords> wanted = *narrowing.materials;
  if (wanted.empty()) wanted.emplace_back();
  for (const Keywords& material : wanted) {
    Keywords on;
    for (const KeywordSet& set : sets) {
      if (!is_by_material(set, narrowing)) continue;
      if (set.alternatives.empty()) return joined;
      const Keywords& used = used_by(material, set);
      on.insert(on.end(), used.begin(), used.end());
    }
    Choice choice = numbering.choice_of(on);
    choice.erase(std::unique(choice.begin(), choice.end()), choice.end());
    joined.alternatives.push_back(std::move(choice));
  }
  drop_repeated(joined.alternatives);
  return joined;
}

std::vector<Tie> ties_of(const std::vector<Clause>& clauses, Numbering& numbering) {
  std::vector<Tie> ties;
  for (const Clause& clause : clauses) {
    Tie tie{clause.when.empty() ? -1 : numbering.number_of(clause.when), {}, clause.said_by};
    for (const std::string& keyword : clause.any_of) tie.any_of.push_back(numbering.number_of(keyword));
    ties.push_back(std::move(tie));
  }
  return ties;
}

std::vector<std::vector<Choice>> seen_by(hlsl::Stage stage, const std::vector<std::vector<Choice>>& axes,
                                         const std::vector<StageSet>& stages_of) {
  std::vector<std::vector<Choice>> seen = axes;
  for (std::vector<Choice>& choices : seen) {
    for (Choice& choice : choices)
      std::erase_if(choice,
                    [&](int keyword) { return !stages_of[static_cast<std::size_t>(keyword)].has(stage); });
    drop_repeated(choices);
  }
  return seen;
}

}  // namespace

VariantList::VariantList(std::vector<std::vector<Choice>> axes, std::shared_ptr<const Keywords> names)
    : axes_(std::move(axes)), others_(axes_.size(), VariantCount(1)), names_(std::move(names)) {
  VariantCount before(1);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    others_[i] *= before;
    before *= VariantCount(axes_[i].size());
  }
  VariantCount behind(1);
  for (std::size_t i = axes_.size(); i-- > 0;) {
    others_[i] *= behind;
    behind *= VariantCount(axes_[i].size());
  }
}

VariantCount VariantList::count() const {
  VariantCount count(1);
  for (const std::vector<Choice>& choices : axes_) count *= VariantCount(choices.size());
  return count;
}

Keywords VariantList::at(std::uint64_t index) const {
  const VariantCount all = count();
  if (!all.saturated() && index >= all.value()) throw std::out_of_range("no such variant");
  Choice on;
  for (std::size_t axis = axes_.size(); axis-- > 0;) {
    const std::vector<Choice>& choices = axes_[axis];
    const Choice& choice = choices[index % choices.size()];
    on.insert(on.end(), choice.begin(), choice.end());
    index /= choices.size();
  }
  std::sort(on.begin(), on.end());
  Keywords keywords;
  for (const int keyword : on) keywords.push_back((*names_)[static_cast<std::size_t>(keyword)]);
  return keywords;
}

Narrowing on_api(Narrowing narrowing, GraphicsApi api) {
  if (api == GraphicsApi::gles3) std::erase(narrowing.stereo_modes, "STEREO_INSTANCING_ON");
  return narrowing;
}

KeywordSpace::KeywordSpace(const Pragmas& pragmas, const Narrowing& narrowing)
    : sets_(declared_sets(pragmas, narrowing)), dynamic_(pragmas.dynamic_keywords) {
  Numbering numbering;
  std::vector<StageSet> stages_of;
  for (const KeywordSet& set : sets_) {
    for (const std::string& keyword : keywords_of(set)) {
      const auto number = static_cast<std::size_t>(numbering.number_of(keyword));
      stages_of.resize(std::max(stages_of.size(), number + 1));
      stages_of[number].add(set.stages);
    }
  }
  Narrower narrower(sets_);
  std::vector<Clause> clauses = pragmas.clauses;
  clauses.insert(clauses.end(), narrowing.clauses.begin(), narrowing.clauses.end());
  narrower.apply(clauses);
  emptied_by_ = narrower.emptied_by;

  std::vector<JoinedSet> joined;
  std::vector<std::size_t> joined_of_set;
  std::optional<std::size_t> of_materials;
  for (const KeywordSet& set : sets_) {
    const bool by_material = is_by_material(set, narrowing);
    if (by_material && of_materials) {
      joined_of_set.push_back(*of_materials);
      continue;
    }
    joined_of_set.push_back(joined.size());
    if (by_material) {
      of_materials = joined.size();
      joined.push_back(material_set(sets_, narrowing, numbering));
    } else {
      joined.emplace_back();
      for (const Keywords& alternative : set.alternatives)
        joined.back().alternatives.push_back(numbering.choice_of(alternative));
    }
    joined.back().place = text_of(set.place);
  }

  const std::vector<Tie> ties = ties_of(narrower.tying, numbering);
  Axes axes = join(joined, ties);
  if (emptied_by_.empty()) emptied_by_ = axes.emptied_by;
  for (const std::size_t of_set : joined_of_set) axis_of_set_.push_back(axes.axis_of_set[of_set]);
  const auto names = std::make_shared<const Keywords>(numbering.names());
  for (const hlsl::Stage stage : hlsl::all_stages)
    of_stage_.push_back(VariantList(seen_by(stage, axes.choices, stages_of), names));
  whole_ = VariantList(std::move(axes.choices), names);
}

const VariantList& KeywordSpace::variants(hlsl::Stage stage) const {
  for (std::size_t i = 0; i < of_stage_.size(); ++i)
    if (hlsl::all_stages[i] == stage) return of_stage_[i];
  return whole_;
}

VariantCount KeywordSpace::count_without(std::size_t set, std::optional<hlsl::Stage> stage) const {
  const VariantList& list = stage ? variants(*stage) : whole_;
  const KeywordSet& still = sets_.at(set);
  if (still.alternatives.empty()) return list.count();
  const Keywords kept = can_be_off(still) ? Keywords{} : still.alternatives.front();
  const Keywords declared = keywords_of(still);
  const std::set<std::string_view> keywords(declared.begin(), declared.end());
  const auto stands = [&](const Choice& choice) {
    return std::all_of(choice.begin(), choice.end(), [&](int number) {
      const std::string& name = (*list.names_)[static_cast<std::size_t>(number)];
      return !keywords.contains(name) || contains(kept, name);
    });
  };
  const std::size_t axis = axis_of_set_[set];
  const std::vector<Choice>& choices = list.axes_[axis];
  const auto standing = static_cast<std::uint64_t>(std::count_if(choices.begin(), choices.end(), stands));
  return standing == 0 ? list.count() : list.others_[axis] * VariantCount(standing);
}

}  // namespace penumbra::variants
