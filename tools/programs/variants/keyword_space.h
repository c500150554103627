// The variants of one program: every combination of its keyword sets that the narrowing permits.
//
// A variant takes one alternative of every set and is identified by the set of keywords that are then
// defined. Sets are independent unless they share a keyword or a clause refers to both; dependent sets are
// joined, and each distinct combination that satisfies the clauses counts once. So counts are exact without
// enumeration. A stage sees only the keywords of its sets: variants that differ only in others are one.
//
// `dynamic_branch` keywords multiply nothing (keyword_set.h says what they become). `shader_feature` sets
// span every combination, or, with `materials`, only the combinations that materials enable: all those sets
// together then have one alternative for each distinct material.
//
// Stage suffixes (_fragment and so on) hold for every target here. For OpenGL and Vulkan the editor reverts
// them to plain directives, and for Metal a keyword of the vertex stage is one of the tessellation stages,
// too (Unity Manual 2020.3, "Declaring and using shader keywords", stage-specific directives): there a vertex
// shader is also compiled with the fragment stage's keywords defined. The variants of the whole program
// include those.
//
// Guarantees: the same program and narrowing give the same variants in the same order, the first set varying
// slowest; variants can be accessed by index. Throws InputError when sets that depend on each other span more
// than 65,536 combinations: its message names them. Source: Unity Manual, "How Unity compiles branching
// shaders", "Shader variant stripping".
#pragma once

#include <iterator>
#include <memory>

#include "hlsl/stage.h"
#include "variants/keyword_join.h"
#include "variants/keyword_set.h"
#include "variants/platform_defines.h"
#include "variants/pragmas.h"
#include "variants/variant_count.h"

namespace penumbra::variants {

struct Narrowing {
  std::vector<Clause> clauses;
  std::optional<std::vector<Keywords>> materials;  // if absent, shader_feature sets span all combinations
  Keywords stereo_modes;                           // see stereo_set() in pragma_names.h; empty for no XR
  std::string tiers_for;                           // renderer for which hardware_tier_variants count
  std::vector<std::string> unused_passes{};        // names or LightMode tags: none of their variants is built
  bool materials_decide_all = false;               // `materials` decides the sets of multi_compile, too
};

// Adapts a narrowing to a graphics API: OpenGL ES draws both eyes by multiview instead of instancing (Unity
// Manual, "Stereo rendering"), and its vertex shaders cannot select a layer, so STEREO_INSTANCING_ON is not a
// mode there.
Narrowing on_api(Narrowing narrowing, GraphicsApi api);

class VariantList {
 public:
  VariantCount count() const;
  // Returns the keywords that are defined, in the order of their declaration. Throws std::out_of_range.
  Keywords at(std::uint64_t index) const;

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Keywords;
    using difference_type = std::ptrdiff_t;
    using pointer = const Keywords*;
    using reference = Keywords;
    Iterator() = default;
    Iterator(const VariantList* list, std::uint64_t index) : list_(list), index_(index) {}
    Keywords operator*() const { return list_->at(index_); }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    void operator++(int) { ++index_; }
    bool operator==(const Iterator& other) const { return index_ == other.index_; }

   private:
    const VariantList* list_ = nullptr;
    std::uint64_t index_ = 0;
  };
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, count().value()}; }

 private:
  friend class KeywordSpace;
  VariantList() = default;
  VariantList(std::vector<std::vector<Choice>> axes, std::shared_ptr<const Keywords> names);

  std::vector<std::vector<Choice>> axes_;
  std::vector<VariantCount> others_;  // for each axis, the product of the other axes' sizes
  std::shared_ptr<const Keywords> names_;
};

class KeywordSpace {
 public:
  explicit KeywordSpace(const Pragmas& pragmas, const Narrowing& narrowing = {});

  const VariantList& variants(hlsl::Stage stage) const;
  const VariantList& whole_program() const { return whole_; }

  // Returns the sets after the narrowing of each set on its own.
  const std::vector<KeywordSet>& sets() const { return sets_; }
  const std::vector<DynamicKeyword>& dynamic_keywords() const { return dynamic_; }

  // Returns the number of variants of the stage (without one: of the whole program) if the set were fixed at
  // its empty keyword, or at its first alternative if it has none.
  VariantCount count_without(std::size_t set, std::optional<hlsl::Stage> stage) const;

  // Returns why there are no variants, or empty.
  const std::string& emptied_by() const { return emptied_by_; }

 private:
  std::vector<KeywordSet> sets_;
  std::vector<std::size_t> axis_of_set_;
  std::vector<DynamicKeyword> dynamic_;
  VariantList whole_;
  std::vector<VariantList> of_stage_;  // indexed by hlsl::Stage
  std::string emptied_by_;
};

}  // namespace penumbra::variants
