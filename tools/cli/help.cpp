#include "cli/help.h"

#include <fmt/format.h>

#include <memory>
#include <sstream>

#include "cli/option_values.h"

namespace penumbra::cli {
namespace {

constexpr std::size_t kIndent = 26;
constexpr std::size_t kWidth = 100;

// Wraps the text to lines that fit beside the option's name.
std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  std::size_t column = kIndent;
  for (std::string word; words >> word;) {
    if (column > kIndent && column + 1 + word.size() > kWidth) {
      result += '\n' + std::string(kIndent, ' ');
      column = kIndent;
    }
    if (column > kIndent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

std::string two_columns(const std::string& left, const std::string& right) {
  const std::string start = "  " + left;
  const bool beside = start.size() + 2 <= kIndent;
  return start + (beside ? std::string(kIndent - start.size(), ' ') : "\n" + std::string(kIndent, ' ')) +
         wrapped(right) + "\n";
}

std::string names_of(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
  return names;
}

// Returns "0.53,2,5" for "[0.53,2,5]", which is CLI11's text of a list's values.
std::string default_of(const CLI::Option& option) {
  std::string text = option.get_default_str();
  if (text.size() >= 2 && text.front() == '[' && text.back() == ']') text = text.substr(1, text.size() - 2);
  return text;
}

std::string placeholder_of(const CLI::Option& option, const ValueHint& hint) {
  if (hint.placeholder.empty()) return "";
  const bool list =
      option.get_expected_max() > 7 && (option.get_delimiter() == ',' || hint.placeholder == "SCENE");
  if (list) return " " + hint.placeholder + "[,...]";
  return " " + hint.placeholder;
}

std::string description_of(const CLI::Option& option, const ValueHint& hint) {
  std::string text = option.get_description();
  if (!hint.rule.empty()) text += "; " + hint.rule;
  if (!option.get_positional() && option.get_expected_max() > 7) text += "; repeatable";
  for (const CLI::Option* other : option.get_needs()) text += "; needs " + other->get_name();
  if (!hint.placeholder.empty() && !option.get_required() && !default_of(option).empty())
    text += " [default: " + default_of(option) + "]";
  return text;
}

class Layout : public CLI::Formatter {
 public:
  Layout() { column_width(kIndent); }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    const ValueHint hint = value_hint(*option);
    const std::string left =
        is_positional ? option->get_name(true) : names_of(*option) + placeholder_of(*option, hint);
    return two_columns(left, description_of(*option, hint));
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return two_columns(command->get_name(), command->get_description());
  }
};

}  // namespace

void lay_out_help(CLI::App& app) {
  app.formatter(std::make_shared<Layout>());
}

void end_help(CLI::App& command, const std::string& notes, const std::vector<Example>& examples) {
  std::string text = notes.empty() ? "" : notes + "\n\n";
  text += "Examples:\n";
  for (const Example& example : examples) {
    if (*example.meaning != '\0') text += fmt::format("  # {}\n", example.meaning);
    text += fmt::format("  {}\n", example.command);
  }
  command.footer(text + "\n" + command.get_parent()->get_footer());
}

}  // namespace penumbra::cli
