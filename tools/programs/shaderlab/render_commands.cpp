#include "shaderlab/render_commands.h"

#include <algorithm>

namespace penumbra::shaderlab {
namespace {

// The text is without the zeros behind the point: "4", "0.5".
std::string number_text(double number) {
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string default_of(const Shader& shader, const std::string& property) {
  for (const Property& declared : shader.properties)
    if (declared.name.text == property && !declared.default_numbers.empty())
      return number_text(declared.default_numbers.front());
  return "0";
}

void add(const Shader& shader, const std::vector<Command>& written, std::vector<RenderCommand>& commands) {
  for (const Command& command : written) {
    RenderCommand added{command.name.text, {}, command.name.place, {}};
    for (const Command::Value& value : command.values) {
      if (value.kind == Command::Value::Kind::punctuation && value.text == ",") continue;
      const bool property = value.kind == Command::Value::Kind::property;
      added.values.push_back(property ? default_of(shader, value.text) : value.text);
    }
    add(shader, command.block, added.block);
    commands.push_back(std::move(added));
  }
}

}  // namespace

std::vector<RenderCommand> render_commands(const Program& program) {
  const Shader& shader = *program.shader;
  std::vector<const Settings*> inside_out;
  if (program.pass != nullptr) inside_out.push_back(&program.pass->settings);
  inside_out.push_back(&program.sub_shader->settings);
  for (int i = program.sub_shader->category; i >= 0;
       i = shader.categories[static_cast<std::size_t>(i)].parent)
    inside_out.push_back(&shader.categories[static_cast<std::size_t>(i)].settings);
  std::vector<RenderCommand> commands;
  for (auto settings = inside_out.rbegin(); settings != inside_out.rend(); ++settings)
    add(shader, (*settings)->commands, commands);
  return commands;
}

}  // namespace penumbra::shaderlab
