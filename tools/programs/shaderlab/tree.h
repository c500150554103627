// The syntax tree of a .shader file, with the location of everything in it. Editors, dependencies, the
// fallback and the requirements of packages are read and not kept: nothing here depends on them.
//
// Lines and columns are 1-based and count the bytes of the normalised text (hlsl::normalise_source); an
// offset counts the same bytes from 0. Names keep the file's spelling. Based on Unity's ShaderLab reference,
// https://docs.unity3d.com/Manual/SL-Reference.html.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra::shaderlab {

struct Place {
  int line = 0;  // 0 if it is not in the file
  int column = 0;
  std::size_t offset = 0;
};

struct Name {
  std::string text;
  Place place;
};

enum class Language { hlsl, cg, glsl };

// HLSLPROGRAM ... ENDHLSL and similar blocks: the code is between begin and end.
struct CodeBlock {
  Language language = Language::hlsl;
  bool is_include = false;  // HLSLINCLUDE rather than HLSLPROGRAM
  Place keyword;            // place of the opening keyword
  Place begin;              // right after that keyword
  Place end;                // place of the closing keyword
};

// A command, such as Cull [_Cull], Blend One Zero, or Stencil { Ref 2 Comp Always }.
struct Command {
  struct Value {
    enum class Kind {
      identifier,
      number,
      string,
      property,
      punctuation
    };  // property: [_Name]; punctuation: , ( ) + - *
    Kind kind = Kind::identifier;
    std::string text;
    Place place;
  };
  Name name;
  std::vector<Value> values;
  std::vector<Command> block;  // the contents of its braces
};

struct Tag {
  Name key;
  Name value;
};

// The settings that Pass, SubShader and Category have in common.
struct Settings {
  std::vector<Tag> tags;
  std::vector<Command> commands;
};

struct Pass {
  enum class Kind { pass, use_pass, grab_pass };
  Kind kind = Kind::pass;
  Place place;
  Name name;  // its Name; for UsePass the path "Shader/PASSNAME", for GrabPass the texture's name
  Settings settings;
  std::vector<CodeBlock> programs;
};

// A Category's tags, commands and LOD hold for every SubShader inside.
struct Category {
  Place place;
  int parent = -1;  // index into Shader::categories; -1 for none
  Settings settings;
};

struct SubShader {
  Place place;
  int category = -1;  // index into Shader::categories; -1 for none
  Settings settings;
  std::vector<Pass> passes;         // passes with UsePass and GrabPass, in the order of the file
  std::vector<CodeBlock> programs;  // programs outside any Pass: surface shaders
};

enum class PropertyType { float_, range, int_, integer, color, vector, texture };

struct Attribute {
  Name name;              // HideInInspector, Toggle, Enum
  std::string arguments;  // the contents of its parentheses, verbatim
};

struct Property {
  Name name;
  std::string display_name;
  PropertyType type = PropertyType::float_;
  std::string type_name;                // "2D", "CubeArray", "Range", as written
  std::vector<double> default_numbers;  // one for scalars, as many as written for Color and Vector
  std::vector<Attribute> attributes;
};

struct Shader {
  std::string file;  // its name in diagnostics
  std::string text;  // normalised; every offset is into it
  Name name;
  std::vector<Property> properties;
  std::vector<Category> categories;
  std::vector<SubShader> sub_shaders;
  std::vector<CodeBlock> includes;  // HLSLINCLUDE and similar blocks, wherever they are
};

// Returns the tag's value, or nullptr; keys are compared as Unity does, by case.
const std::string* find_tag(const std::vector<Tag>& tags, std::string_view key);

const char* language_name(Language language);  // "HLSL"; with PROGRAM, INCLUDE or after END a keyword

}  // namespace penumbra::shaderlab
