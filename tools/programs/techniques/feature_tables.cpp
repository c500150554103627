#include "techniques/feature_tables.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "input/input_error.h"
#include "techniques/emitted_text.h"
#include "techniques/parameter_packing.h"
#include "techniques/technique_call.h"
#include "techniques/texel_formats.h"

namespace penumbra::techniques {

namespace {

std::string texture_row(const GraphTexture& texture) {
  TableRow row("texture");
  row.add(texture.name)
      .add(csharp_name(name_of(texture.extent)))
      .add(find_texel_format(texture.format)->unity);
  row.option("divisor", texture.divisor, 1);
  if (texture.extent == ExtentOf::fixed)
    row.option("width", texture.size[0], 0)
        .option("height", texture.size[1], 0)
        .option("depth", texture.size[2], 1);
  row.option("mips", texture.mips, 1).option("layers", texture.layers, 1);
  return row.option("samples", texture.samples, 1).line();
}

std::string groups_row(const GroupCount& groups) {
  if (!groups.texels_of.empty())
    return TableRow("groupsOfTexels").add(groups.texels_of).option("divisor", groups.divisor, 1).line();
  return TableRow("groups").add(groups.fixed[0]).add(groups.fixed[1]).add(groups.fixed[2]).line();
}

std::string pass_rows(const GraphPass& pass) {
  TableRow row("pass");
  row.add(csharp_name(name_of(pass.kind))).add(csharp_name(name_of(pass.frequency)));
  row.add(pass.file).add(pass.program);
  row.option("testsShadowMap", pass.depth == shadow_map_name);
  row.option("blended", pass.casters == DrawnCasters::blended).option("eachMip", pass.each_mip);
  std::string rows = row.line();
  const auto bind = [&](const char* kind, const std::pair<std::string, std::string>& bound) {
    rows += TableRow(kind).add(bound.first).add(bound.second).line();
  };
  for (const auto& read : pass.reads) bind("read", read);
  for (const std::string& property : pass.absent) rows += TableRow("absent").add(property).line();
  for (const auto& written : pass.writes)
    if (!changes(pass, written.second)) bind("write", written);
  for (const auto& written : pass.writes)
    if (changes(pass, written.second)) bind("update", written);
  if (!pass.depth.empty() && pass.depth != shadow_map_name) rows += TableRow("depth").add(pass.depth).line();
  return pass.kind == PassKind::compute ? rows + groups_row(pass.groups) : rows;
}

// These are the arguments of the filter at the end, or of filters of shaders after the passes, each under its
// name.
std::string filter_rows(const PassGraph& graph) {
  const GraphPass* last = graph.filter_pass();
  const bool linear = last != nullptr && last->filter->takes("linearSampler");
  std::string rows;
  for (const std::string& name : last == nullptr ? graph.published : last->filter->arguments)
    if (graph.texture(name) != nullptr)
      rows += TableRow("filterTexture")
                  .add("_Penumbra" + csharp_name(name) + "Texture")
                  .add(name)
                  .option("linear", linear)
                  .line();
  return rows;
}

std::string rows_of(const NamedGraph& named) {
  const PassGraph& graph = named.graph;
  std::string rows = TableRow("graph").add(named.name).line();
  for (const GraphTexture& texture : graph.textures) rows += texture_row(texture);
  for (const GraphTexture& texture : graph.textures)
    if (!texture.previous_of.empty())
      rows += TableRow("previous").add(texture.name).add(texture.previous_of).line();
  for (const GraphPass& pass : graph.passes)
    if (pass.kind != PassKind::filter) rows += pass_rows(pass);
  for (const std::string& keyword : graph.keywords) rows += TableRow("keyword").add(keyword).line();
  rows += filter_rows(graph);
  for (const auto& [kind, name] :
       {std::pair{"visibility", graph.visibility}, {"source", graph.source}, {"mask", graph.mask}})
    if (!name.empty()) rows += TableRow(kind).add(name).line();
  return rows;
}

// The renderer feature has no passes with a stencil: graphs with one are for measuring, and for shaders and
// samples to follow.
bool is_drawn_by_feature(const NamedGraph& named) {
  return std::none_of(named.graph.passes.begin(), named.graph.passes.end(),
                      [](const GraphPass& pass) { return !pass.stencil.empty(); });
}

constexpr const char* kTechniqueEnum = R"(using UnityEngine;

namespace Penumbra
{{
    // Written by `penumbra emit` from the manifests, *.technique.json; do not edit.
    /// <summary>
    /// The technique that computes the visibility: one entry for each shader keyword of ShaderLibrary/Shadows.hlsl that
    /// the feature offers, and for each that passes of its own draw. Inspectors, documentation and reports use these
    /// names.
    /// </summary>
    public enum ShadowTechnique
    {{
{}    }}
}}
)";

constexpr const char* kTechniqueEntry = R"(        /// <summary>{doc}</summary>
        [InspectorName({title})] {name} = {value},
)";

std::vector<const Selection*> offered(const TechniqueList& list) {
  std::vector<const Selection*> selections;
  for (const Selection& selection : list.selections)
    if (selection.value) selections.push_back(&selection);
  std::sort(selections.begin(), selections.end(),
            [](const Selection* a, const Selection* b) { return *a->value < *b->value; });
  for (std::size_t i = 0; i < selections.size(); ++i)
    if (*selections[i]->value != static_cast<int>(i))
      throw InputError(selections[i]->where, "no selection has the value " + std::to_string(i),
                       "values are 0, 1, 2 and so on, each once");
  return selections;
}

// Returns the techniques of a selection, by the formats of their maps.
std::vector<const Technique*> techniques_of(const TechniqueList& list, const Selection& selection) {
  std::vector<const Technique*> techniques{&list.find(selection.technique)};
  if (!selection.technique_16_bits.empty()) techniques.push_back(&list.find(selection.technique_16_bits));
  return techniques;
}

std::string option_that_sets(const Selection& selection, const std::string& field) {
  for (const auto& [option, set] : selection.options)
    if (set == field) return option;
  return {};
}

bool is_computed(const Selection& selection, const std::string& parameters) {
  return std::find(selection.computed_parameters.begin(), selection.computed_parameters.end(), parameters) !=
         selection.computed_parameters.end();
}

// A component is a number, or option:low:high where the option sets the field.
std::string vector_rows(const ParameterStruct& parameters, const Technique& technique,
                        const Selection& selection) {
  const std::vector<std::array<float, 4>> values = packed(parameters, technique.values);
  std::vector<std::array<std::string, 4>> columns(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) columns[i][k] = table_number(values[i][k]);
  const std::vector<PackedPlace> places = packed_places(parameters);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ParameterField& field = parameters.fields[i];
    const std::string option = option_that_sets(selection, field.name);
    if (option.empty()) continue;
    constexpr double kLargest = std::numeric_limits<float>::max();
    const ParameterRange range = field.range.value_or(ParameterRange{-kLargest, kLargest});
    columns[places[i].vector][places[i].component] =
        option + ":" + table_number(range.smallest) + ":" + table_number(range.largest);
  }
  std::string rows;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    TableRow row("vector");
    row.add(uniform_name(parameters, i));
    for (const std::string& column : columns[i]) row.add(column);
    rows += row.line();
  }
  return rows;
}

std::string format_rows(const TechniqueList& list, const Selection& selection, const Technique& technique) {
  std::string rows = TableRow("format").option("graph", technique.graph_name).line();
  for (const ParameterStruct* parameters : list.structs_of(technique))
    if (!is_computed(selection, parameters->name)) rows += vector_rows(*parameters, technique, selection);
  return rows;
}

std::string option_rows(const TechniqueList& list, const Selection& selection) {
  const Technique& technique = list.find(selection.technique);
  std::string rows;
  for (const auto& [option, set] : selection.options)
    rows += TableRow("option").add(option).add(table_number(technique.values.at(set).front())).line();
  return rows;
}

std::string cascade_rows(const TechniqueList& list, const Technique& technique) {
  std::string rows;
  for (const CascadeVector& vector : cascade_vectors(list, technique)) {
    int own = 0;
    for (std::size_t k = 0; k < 4; ++k) own |= vector.own[k] ? 1 << k : 0;
    TableRow row("cascade");
    row.add(vector.uniform).add(vector.base).add(own);
    for (const float value : vector.value) row.add(table_number(value));
    rows += row.line();
  }
  return rows;
}

// The parameters of the filter, or of the passes that draw the visibility, decide it.
bool limits_width(const TechniqueList& list, const Selection& selection) {
  const ParameterStruct* parameters = list.find_struct(selection.filter.parameters);
  std::vector<ParameterField> fields;
  if (selection.draws_visibility)
    fields = list.fields_of(list.find(selection.technique));
  else if (parameters != nullptr)
    fields = parameters->fields;
  return std::any_of(fields.begin(), fields.end(),
                     [](const ParameterField& field) { return field.name == "maxPenumbraMetres"; });
}

bool has_own_bias(const TechniqueList& list, const Selection& selection) {
  const TechniqueBias& bias = list.find(selection.technique).bias;
  return bias.depth == 0.0 && bias.normal == 0.0;
}

// A rule's vectors are copies of those that ShadowUniforms computes.
void require_fitting_rules(const TechniqueList& list, const Selection& selection) {
  for (const CascadeRule& rule : list.find(selection.technique).cascades)
    if (rule.technique.empty() && selection.computed_parameters.empty() && !selection.options.empty())
      throw InputError(
          selection.where,
          "'" + selection.name + "' has options, and rules for cascades that change its own parameters",
          "sliders would not reach far cascades: let ShadowUniforms compute the parameters, and say "
          "\"computed_parameters\": [the struct's name]");
}

std::string fallback_of(const std::vector<const Selection*>& selections, const Selection& selection) {
  const std::string& name = !selection.fallback.empty() ? selection.fallback : selection.name;
  for (const Selection* other : selections)
    if (other->name == name) return name;
  throw InputError(selection.where, "the renderer feature does not offer '" + name +
                                        "', which is drawn where '" + selection.name + "' cannot run");
}

std::string rows_of(const TechniqueList& list, const std::vector<const Selection*>& selections,
                    const Selection& selection) {
  require_fitting_rules(list, selection);
  const Technique& technique = list.find(selection.technique);
  std::string rows = TableRow("technique")
                         .add(selection.name)
                         .add(fallback_of(selections, selection))
                         .option("keyword", selection.keyword)
                         .option("takesSamples", selection.is_sampled)
                         .option("widensWithDisc", selection.widens_with_disc)
                         .option("needsTarget45", selection.needs_target_45)
                         .option("limitsWidth", limits_width(list, selection))
                         .option("hasOwnBias", has_own_bias(list, selection))
                         .line();
  rows += option_rows(list, selection) + cascade_rows(list, technique);
  if (const std::string& half = selection.technique_half_resolution; !half.empty())
    rows += TableRow("half").add(list.find(half).graph_name).line();
  for (const Technique* of_format : techniques_of(list, selection))
    rows += format_rows(list, selection, *of_format);
  return rows;
}

}  // namespace

std::string graph_rows(const TechniqueList& list) {
  std::map<std::string, const NamedGraph*> named;
  std::string rows;
  for (const NamedGraph& graph : list.graphs) {
    if (!is_drawn_by_feature(graph)) continue;
    const auto [other, is_first] = named.emplace(graph.name, &graph);
    if (!is_first)
      throw InputError(graph.where, "'" + graph.name + "' is the name of another graph, too",
                       "that is at " + other->second->where + ": give one of them another name");
    rows += rows_of(graph);
  }
  return rows;
}

std::string emit_selections_csharp(const TechniqueList& list) {
  std::string entries;
  for (const Selection* selection : offered(list))
    entries += (entries.empty() ? "" : "\n") +
               fmt::format(kTechniqueEntry, fmt::arg("doc", xml_text(selection->doc)),
                           fmt::arg("title", csharp_text(selection->title)),
                           fmt::arg("name", selection->name), fmt::arg("value", *selection->value));
  return fmt::format(kTechniqueEnum, entries);
}

std::string selection_rows(const TechniqueList& list) {
  const std::vector<const Selection*> selections = offered(list);
  std::string rows;
  for (const Selection* selection : selections) rows += rows_of(list, selections, *selection);
  return rows;
}

}  // namespace penumbra::techniques
