#include <deal.II/base/patterns.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "prosup/core/parameters.h"
#include "prosup/core/text_file.h"

namespace prosup {

namespace {

using Json = nlohmann::ordered_json;
using dealii::Patterns::PatternBase;

bool is_entry(const Json& node) {
  return node.contains("pattern_description") && node["pattern_description"].is_string();
}

/// Words as a cell of a table takes them.
std::string cell(const std::string& words) {
  std::string text;
  for (const char c : words)
    text += c == '|' ? "\\|" : c == '<' ? "&lt;" : c == '\n' ? " " : std::string(1, c);
  return text;
}

/// What deal.II says of a pattern, in few words.
std::string in_short(std::string words) {
  static const std::pair<std::regex, const char*> rules[] = {
      {std::regex(" v such that -MAX_DOUBLE <= v <= MAX_DOUBLE"), ""},
      {std::regex("A floating point number( v such that (\\S+) <= v <= ([^\\s\\]]+))?"),
       "number $2 to $3"},
      {std::regex("number  to "), "number"},
      {std::regex("An integer n such that (\\S+) <= n <= ([^\\s\\]]+)"), "integer $1 to $2"},
      {std::regex("Any one of "), ""},
      {std::regex("Any string"), "text"},
      {std::regex("A boolean value \\(true or false\\)"), "true, false"},
      {std::regex("A list of (\\d+) to \\1 elements where each element is"), "$1 of"},
      {std::regex("A list of (\\d+) to 4294967295 elements where each element is"),
       "$1 or more of"},
      {std::regex("A list of (\\d+) to (\\d+) elements where each element is"), "$1 to $2 of"},
      {std::regex("A key:value map of .* where each key is (.*) and each value is"), "$1:"}};
  for (const auto& [long_words, short_words] : rules)
    words = std::regex_replace(words, long_words, short_words);
  return words;
}

std::string allowed(const Json& entry) {
  const auto pattern =
      dealii::Patterns::pattern_factory(entry["pattern_description"].get<std::string>());
  return pattern == nullptr ? "" : in_short(pattern->description(PatternBase::Text));
}

void add_section(const Json& section, const std::string& path, std::string& text) {
  std::string rows;
  for (const auto& [name, node] : section.items())
    if (is_entry(node)) {
      const std::string value = node["default_value"];
      rows += "| `" + name + "` | " + (value.empty() ? "" : "`" + cell(value) + "`") + " | " +
              cell(allowed(node)) + " | " + cell(node["documentation"]) + " |\n";
    }
  if (!rows.empty())
    text += "\n## " + path + "\n\n| entry | default | allowed | what it is |\n|---|---|---|---|\n" +
            rows;
  for (const auto& [name, node] : section.items())
    if (!is_entry(node))
      add_section(node, (path.empty() ? "" : path + "/").append(name), text);
}

} // namespace

void write_parameter_reference(const dealii::ParameterHandler& parameters,
                               const std::filesystem::path& file) {
  using dealii::ParameterHandler;
  std::stringstream json;
  parameters.print_parameters(json,
                              ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
  std::string text =
      "# Parameters\n\nA parameter file sets an entry by `set Entry = value` in "
      "`subsection Section` ... `end`, the command line by `--set "
      "\"Section/Entry=value\"`. `prosup register --write-prm FILE.prm` writes a file "
      "with all of them; this page is what `--write-prm FILE.md` writes.\n";
  add_section(Json::parse(json), "", text);
  write_text_file(text, file);
}

} // namespace prosup
