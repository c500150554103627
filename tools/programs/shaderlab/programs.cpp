#include "shaderlab/programs.h"

#include "preprocessing/directive_lines.h"

namespace penumbra::shaderlab {

namespace {

// Places blocks of a file one after the other, each at its own line and column.
class ProgramText {
 public:
  explicit ProgramText(std::string_view file) : file_(file) {}

  void add(const CodeBlock& block) {
    if (block.begin.offset >= at_ && (at_ == 0 || block.begin.line > line_)) {
      blank_until(block.begin.offset);
    } else {
      text_ += "\n#line " + std::to_string(block.begin.line) + "\n";
      text_.append(static_cast<std::size_t>(block.begin.column - 1), ' ');
    }
    text_ += file_.substr(block.begin.offset, block.end.offset - block.begin.offset);
    at_ = block.end.offset;
    line_ = block.end.line;
  }

  std::string take() { return std::move(text_); }

 private:
  void blank_until(std::size_t offset) {
    for (; at_ < offset; ++at_) text_ += file_[at_] == '\n' ? '\n' : ' ';
  }

  std::string_view file_;
  std::string text_;
  std::size_t at_ = 0;  // offset in the file
  int line_ = 0;        // the line on which the last block ended
};

std::string program_text(const Shader& shader, const CodeBlock& program) {
  ProgramText text(shader.text);
  for (const CodeBlock& include : shader.includes)
    if (include.language == program.language) text.add(include);
  text.add(program);
  return text.take();
}

class Collector {
 public:
  explicit Collector(const Shader& shader) : shader_(shader) {}

  std::vector<Program> run() {
    for (const SubShader& sub_shader : shader_.sub_shaders) {
      sub_shader_ = &sub_shader;
      pass_ = nullptr;
      for (const CodeBlock& block : sub_shader.programs) add(block);
      for (const Pass& pass : sub_shader.passes) {
        pass_ = &pass;
        for (const CodeBlock& block : pass.programs) add(block);
      }
    }
    return std::move(programs_);
  }

 private:
  void add(const CodeBlock& block) {
    Program program;
    program.file = shader_.file;
    program.text = program_text(shader_, block);
    program.language = block.language;
    program.place = block.keyword;
    program.implicit_includes = block.language == Language::cg;
    for (const preprocessing::DirectiveLine& pragma : preprocessing::directive_lines(program.text)) {
      if (pragma.name != "pragma" || pragma.words.empty()) continue;
      program.is_surface_shader |= pragma.words.front().text == "surface";
      program.is_ray_tracing |= pragma.words.front().text == "raytracing";
    }
    program.shader = &shader_;
    program.sub_shader = sub_shader_;
    program.pass = pass_;
    program.sub_shader_index = static_cast<int>(sub_shader_ - shader_.sub_shaders.data());
    if (pass_ != nullptr) program.pass_index = static_cast<int>(pass_ - sub_shader_->passes.data());
    programs_.push_back(std::move(program));
  }

  const Shader& shader_;
  const SubShader* sub_shader_ = nullptr;
  const Pass* pass_ = nullptr;
  std::vector<Program> programs_;
};

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

std::vector<Program> programs(const Shader& shader) {
  return Collector(shader).run();
}

std::string_view pass_name(const Program& program) {
  return program.pass == nullptr ? std::string_view() : std::string_view(program.pass->name.text);
}

const std::string* effective_tag(const Program& program, std::string_view key) {
  if (program.pass != nullptr)
    if (const std::string* value = find_tag(program.pass->settings.tags, key)) return value;
  if (const std::string* value = find_tag(program.sub_shader->settings.tags, key)) return value;
  const std::vector<Category>& categories = program.shader->categories;
  for (int i = program.sub_shader->category; i >= 0; i = categories[static_cast<std::size_t>(i)].parent)
    if (const std::string* value = find_tag(categories[static_cast<std::size_t>(i)].settings.tags, key))
      return value;
  return nullptr;
}

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
