#include "prosup/core/parameters.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/utilities.h>

#include <fstream>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/exception_text.h"
#include "prosup/core/text.h"

namespace prosup {

using namespace dealii;

namespace {

constexpr const char* where_allowed = "; --write-prm FILE lists all entries and what they allow.";

/// Ends a message on a value that does not match its pattern with what is allowed
/// in words, where deal.II has it in its own notation, as in <[Selection a|b ]>.
/// The last mention of a pattern is deal.II's: one before may stand in the file.
std::string with_readable_pattern(const std::string& text) {
  const std::size_t verdict = text.rfind("does not match the given pattern");
  const std::size_t begin = text.find('[', verdict), end = text.rfind(']');
  if (verdict == std::string::npos || begin == std::string::npos || end < begin)
    return text;
  const auto pattern = Patterns::pattern_factory(text.substr(begin, end - begin + 1));
  if (pattern == nullptr) // brackets in the value itself
    return text;
  return text.substr(0, verdict) +
         "is not allowed there, but: " + pattern->description(Patterns::PatternBase::Text);
}

/// The message of a deal.II exception as part of one sentence, without its stack
/// trace.
std::string as_clause(const ExceptionBase& exception) {
  std::ostringstream text;
  exception.print_info(text);
  std::string line = on_one_line(text.str());
  while (!line.empty() && line.back() == '.')
    line.pop_back();
  // What others quote from the file may look like a pattern, and deal.II's reader of patterns
  // does not survive half of one.
  const bool names_pattern =
      dynamic_cast<const ParameterHandler::ExcValueDoesNotMatchPattern*>(&exception) != nullptr ||
      dynamic_cast<const ParameterHandler::ExcInvalidEntryForPattern*>(&exception) != nullptr;
  return names_pattern ? with_readable_pattern(line) : line;
}

/// The files that `file` includes, as deal.II reads them: relative to the working folder.
std::vector<std::filesystem::path> included(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::string text = Utilities::trim(line);
    if (text.rfind("include ", 0) == 0 || text.rfind("INCLUDE ", 0) == 0)
      files.push_back(Utilities::trim(text.substr(8)));
  }
  return files;
}

/// deal.II follows files that include each other for ever. `chain` leads to `file`.
/// @throws Error if they do.
void refuse_endless_includes(const std::filesystem::path& file,
                             std::vector<std::filesystem::path>& chain) {
  std::error_code ignored;
  for (const std::filesystem::path& before : chain)
    if (std::filesystem::equivalent(before, file, ignored))
      throw Error("The parameter file '" + chain.front().string() + "' cannot be used: '" +
                  chain.back().string() + "' includes '" + file.string() +
                  "', which is being read already; remove this line.");
  if (!std::filesystem::is_regular_file(file, ignored))
    return;
  chain.push_back(file);
  for (const std::filesystem::path& next : included(file))
    refuse_endless_includes(next, chain);
  chain.pop_back();
}

void read_file(ParameterHandler& parameters, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw Error("The parameter file '" + file.string() +
                "' does not exist or is no file; give the path of a .prm file, or write one with "
                "--write-prm.");
  std::vector<std::filesystem::path> chain;
  refuse_endless_includes(file, chain);
  try {
    parameters.parse_input(file.string(), "", false);
  } catch (const ExceptionBase& exception) {
    throw Error("The parameter file '" + file.string() +
                "' cannot be used: " + as_clause(exception) + where_allowed);
  }
}

void apply(ParameterHandler& parameters, const Override& override) {
  const std::size_t equals = override.find('=');
  if (equals == std::string::npos)
    throw Error("The override '" + override + "' has no '='; write --set \"Section/Entry=value\".");
  const std::string value = Utilities::trim(override.substr(equals + 1));
  std::vector<std::string> path = Utilities::split_string_list(override.substr(0, equals), '/');
  const std::string entry = path.empty() ? "" : path.back();
  if (!path.empty())
    path.pop_back();
  if (!path.empty() && !parameters.subsection_path_exists(path))
    throw Error("The section of the override '" + override + "' does not exist" + where_allowed);
  for (const std::string& section : path)
    parameters.enter_subsection(section);
  try {
    parameters.set(entry, value);
  } catch (const ExceptionBase& exception) {
    for (std::size_t i = 0; i < path.size(); ++i)
      parameters.leave_subsection();
    throw Error("The override '" + override + "' cannot be used: " + as_clause(exception) +
                where_allowed);
  }
  for (std::size_t i = 0; i < path.size(); ++i)
    parameters.leave_subsection();
}

} // namespace

void read_parameters(ParameterHandler& parameters, const std::filesystem::path& file,
                     const std::vector<Override>& overrides) {
  ParameterAcceptor::declare_all_parameters(parameters);
  if (!file.empty())
    read_file(parameters, file);
  for (const Override& override : overrides)
    apply(parameters, override);
  ParameterAcceptor::parse_all_parameters(parameters);
}

void read_parameters(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  ParameterHandler parameters;
  read_parameters(parameters, file, overrides);
}

void resolve_files(ParameterHandler& parameters, const std::string& section,
                   const std::vector<std::string>& entries, const std::filesystem::path& folder) {
  parameters.enter_subsection(section);
  for (const std::string& entry : entries) {
    const std::filesystem::path file = parameters.get(entry);
    if (!file.empty() && file.is_relative())
      parameters.set(entry, (folder / file).lexically_normal().string());
  }
  parameters.leave_subsection();
}

void write_parameters(const ParameterHandler& parameters, const std::filesystem::path& file) {
  std::ofstream out(file);
  parameters.print_parameters(out, ParameterHandler::PRM | ParameterHandler::KeepDeclarationOrder);
  out.close();
  if (!out)
    throw Error("The parameters cannot be written to '" + file.string() +
                "'; choose a folder that exists and can be written.");
}

dealii::Patterns::Selection one_of(const std::vector<std::string>& names) {
  return dealii::Patterns::Selection(joined(names, "|"));
}

} // namespace prosup
