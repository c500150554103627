// The facts about a technique besides its measurements: the use for which its manifest recommends it
// and the textures that its passes make; and with them one row for each technique.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/results.h"
#include "study/summary.h"
#include "techniques/technique_list.h"

namespace penumbra::study {

struct TechniqueFacts {
  std::string use_when{};  // one line each, may be empty
  std::string not_when{};
  std::vector<techniques::GraphTexture> textures{};
  bool has_shadow_map = true;  // shadow volumes have none
};

// The lines and textures are the manifests' as they are now, not as they were when the figures were measured:
// lines are written after the figures.
using FactsOfTechniques = std::map<std::string, TechniqueFacts>;

FactsOfTechniques facts_of(const techniques::TechniqueList& list);

// Returns the memory, in MiB, of the shadow map and of the textures that are shares of it or have a fixed
// size, as declared, and of what is baked from the scene. Textures of the picture's size are left out.
double map_mebibytes(const Record& record, const std::vector<techniques::GraphTexture>& textures);

struct TechniqueRow {
  Choice choice;
  std::vector<std::optional<Estimate>> rmse_penumbra{};  // one for each of light_sizes()
  std::optional<Estimate> fetches{};                     // under the middle light
  double map_mebibytes = 0.0;
  bool baked = false;  // some of it is baked from the scene
  std::string use_when{};
  std::string not_when{};
};

// Returns every technique that was measured, in record order; empty if nothing is known of any.
std::vector<TechniqueRow> technique_rows(const Results& results, const FactsOfTechniques& facts);

// rows_explained() says in sentences what the table of these rows shows; its columns of lines are left out
// where no row has one.
bool has_advice(const std::vector<TechniqueRow>& rows);
std::string rows_explained(const std::vector<TechniqueRow>& rows);

double middle_light(const Results& results);  // the one in the middle of light_sizes(), in degrees

}  // namespace penumbra::study
