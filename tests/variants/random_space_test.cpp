// Compares counts and lists of random small spaces with every combination written out and filtered.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "sanitized.h"
#include "variants/keyword_space.h"

namespace penumbra::variants {
namespace {

using Variant = std::set<std::string>;

class RandomSpaces {
 public:
  explicit RandomSpaces(unsigned seed) : random_(seed) {}

  Pragmas pragmas() {
    Pragmas result;
    const int sets = below(6);
    for (int i = 0; i < sets; ++i) {
      KeywordSet set;
      set.stages = stages();
      std::set<Variant> seen;
      for (int j = 1 + below(3); j > 0; --j) {
        const Keywords alternative = below(4) == 0 ? Keywords{} : some_keywords(1 + below(8) / 7);
        if (seen.insert({alternative.begin(), alternative.end()}).second)
          set.alternatives.push_back(alternative);
      }
      set.place = {"a.shader", i + 1, 1};
      result.keyword_sets.push_back(set);
    }
    return result;
  }

  std::vector<Clause> clauses() {
    std::vector<Clause> result;
    for (int i = below(4); i > 0; --i) {
      Clause clause;
      if (below(2) == 0) clause.when = keyword();
      if (clause.when.empty() || below(2) == 0) clause.any_of = some_keywords(1 + below(2));
      clause.whole = clause.when.empty() && below(3) == 0;
      clause.of_their_sets = clause.when.empty() && !clause.whole && below(3) == 0;
      clause.or_none = clause.of_their_sets && below(2) == 0;
      result.push_back(clause);
    }
    return result;
  }

 private:
  int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random_); }
  std::string keyword() { return std::string(1, static_cast<char>('A' + below(9))); }
  Keywords some_keywords(int count) {
    Variant keywords;
    while (static_cast<int>(keywords.size()) < count) keywords.insert(keyword());
    return {keywords.begin(), keywords.end()};
  }
  StageSet stages() {
    if (below(2) == 0) return StageSet::all();
    return below(2) == 0 ? StageSet{hlsl::Stage::fragment} : StageSet{hlsl::Stage::vertex};
  }

  std::mt19937 random_;
};

bool any_in(const Keywords& keywords, const Variant& variant) {
  for (const std::string& keyword : keywords)
    if (variant.contains(keyword)) return true;
  return false;
}

Variant declared_by(const std::vector<KeywordSet>& sets) {
  Variant declared;
  for (const KeywordSet& set : sets)
    for (const Keywords& alternative : set.alternatives)
      declared.insert(alternative.begin(), alternative.end());
  return declared;
}

bool asks(const Clause& clause, const Variant& declared) {
  if (!clause.when.empty()) return true;
  if (!any_in(clause.any_of, declared)) return false;
  for (const std::string& keyword : clause.any_of)
    if (clause.whole && !declared.contains(keyword)) return false;
  return true;
}

// Every combination that satisfies every clause, as the header states them.
std::set<Variant> written_out(const Pragmas& pragmas, const std::vector<Clause>& clauses) {
  const Variant declared = declared_by(pragmas.keyword_sets);
  std::set<Variant> variants{{}};
  for (const KeywordSet& set : pragmas.keyword_sets) {
    std::set<Variant> next;
    const Variant of_set = declared_by({set});
    for (const Keywords& alternative : set.alternatives) {
      const Variant chosen(alternative.begin(), alternative.end());
      bool allowed = true;
      for (const Clause& clause : clauses) {
        if (!clause.of_their_sets || !any_in(clause.any_of, of_set)) continue;
        allowed &= any_in(clause.any_of, chosen) || (clause.or_none && chosen.empty());
      }
      if (!allowed) continue;
      for (Variant variant : variants) {
        variant.insert(chosen.begin(), chosen.end());
        next.insert(variant);
      }
    }
    variants = next;
  }
  std::erase_if(variants, [&](const Variant& variant) {
    for (const Clause& clause : clauses) {
      if (clause.of_their_sets || !asks(clause, declared)) continue;
      const bool applies = clause.when.empty() || variant.contains(clause.when);
      if (applies && !any_in(clause.any_of, variant)) return true;
    }
    return false;
  });
  return variants;
}

std::set<Variant> seen_at(hlsl::Stage stage, const std::set<Variant>& variants, const Pragmas& pragmas) {
  Variant visible;
  for (const KeywordSet& set : pragmas.keyword_sets) {
    if (!set.stages.has(stage)) continue;
    const Variant keywords = declared_by({set});
    visible.insert(keywords.begin(), keywords.end());
  }
  std::set<Variant> seen;
  for (Variant variant : variants) {
    std::erase_if(variant, [&](const std::string& keyword) { return !visible.contains(keyword); });
    seen.insert(variant);
  }
  return seen;
}

void expect_same(const VariantList& list, const std::set<Variant>& expected, unsigned seed) {
  ASSERT_EQ(list.count(), VariantCount(expected.size())) << "seed " << seed;
  std::set<Variant> listed;
  for (const Keywords& keywords : list) {
    EXPECT_EQ(Variant(keywords.begin(), keywords.end()).size(), keywords.size()) << "seed " << seed;
    listed.emplace(keywords.begin(), keywords.end());
  }
  EXPECT_EQ(listed, expected) << "seed " << seed;
}

TEST(RandomSpaces, AreCountedAndListedExactly) {
  for (unsigned seed = 0; seed < 4000 / sanitizer_reduction; ++seed) {
    RandomSpaces random(seed);
    const Pragmas pragmas = random.pragmas();
    const std::vector<Clause> clauses = random.clauses();
    const KeywordSpace space(pragmas, {clauses, {}, {}, {}});
    const std::set<Variant> expected = written_out(pragmas, clauses);
    expect_same(space.whole_program(), expected, seed);
    for (const hlsl::Stage stage : {hlsl::Stage::vertex, hlsl::Stage::fragment, hlsl::Stage::hull}) {
      expect_same(space.variants(stage), seen_at(stage, expected, pragmas), seed);
    }
  }
}

TEST(RandomSpaces, ClausesThatAPragmaBringsWorkAlike) {
  for (unsigned seed = 0; seed < 500 / sanitizer_reduction; ++seed) {
    RandomSpaces random(seed);
    Pragmas pragmas = random.pragmas();
    pragmas.clauses = random.clauses();
    expect_same(KeywordSpace(pragmas).whole_program(), written_out(pragmas, pragmas.clauses), seed);
  }
}

}  // namespace
}  // namespace penumbra::variants
