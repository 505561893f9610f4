#include "manual.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <vector>

#include "command_app.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"

namespace prosup::pipeline {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

/// Text that roff takes as it is.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool starts_line = result.empty() || result.back() == '\n';
    if (starts_line && (c == '.' || c == '\''))
      result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

std::string bold(const std::string& text) {
  return "\\fB" + plain(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + plain(text) + "\\fR";
}

/// "-o" and "--output".
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

std::string option_entry(const CLI::Option& option) {
  std::string entry = bold(joined(names_of(option)));
  if (option.get_positional())
    entry = italic(option.get_name(true));
  else if (!option.get_type_name().empty())
    entry += " " + italic(option.get_type_name());
  std::string text = plain(option.get_description());
  if (option.get_required())
    text += " (required)";
  if (!option.get_default_str().empty())
    text += ". Default: " + plain(option.get_default_str());
  return ".TP\n" + entry + "\n" + text + "\n";
}

std::string synopsis(const CLI::App& program, const CLI::App& command) {
  if (&program == &command)
    return bold(program.get_name()) + " " + italic("COMMAND") + " [" + italic("OPTIONS") + "]";
  std::string line =
      bold(program.get_name() + " " + command.get_name()) + " [" + italic("OPTIONS") + "]";
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional())
      line += " " + italic(option->get_name(true));
  return line;
}

std::string list_of_commands(const CLI::App& program) {
  std::string list;
  for (const CLI::App* command : commands_of(program))
    list += ".TP\n" + bold(command->get_name()) + "\n" + plain(command->get_description()) +
            "; see " + bold(page_name(program, *command)) + "(1)\n";
  return list;
}

/// What is within braces of a type such as "TEXT:{prone,supine}", with blanks between.
std::string choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos)
    return "";
  std::string choices = type.substr(begin + 1, end - begin - 1);
  std::replace(choices.begin(), choices.end(), ',', ' ');
  return choices;
}

std::string options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : names_of(*option))
      names.push_back(name);
  return joined(names, " ");
}

/// Branches of a case of bash for the choices that the options of a command have.
std::string choice_branches(const CLI::App& command) {
  std::string branches;
  for (const CLI::Option* option : command.get_options())
    if (const std::string choices = choices_of(*option); !choices.empty())
      for (const std::string& name : names_of(*option))
        branches += "    '" + command.get_name() + " " + name + "') words='" + choices + "' ;;\n";
  return branches;
}

} // namespace

std::string page_name(const CLI::App& program, const CLI::App& command) {
  return program.get_name() + (&program == &command ? "" : "-" + command.get_name());
}

std::string manual_page(const CLI::App& program, const CLI::App& command) {
  const bool is_program = &program == &command;
  const std::string name = page_name(program, command);
  std::string page = ".TH \"" + plain(name) + "\" 1 \"\" \"" + plain(program.version()) +
                     "\" \"User commands\"\n.SH NAME\n" + plain(name) + " \\- " +
                     plain(command.get_description()) + "\n.SH SYNOPSIS\n" +
                     synopsis(program, command) + "\n";
  if (is_program)
    page += ".SH COMMANDS\n" + list_of_commands(program);
  page += ".SH OPTIONS\n";
  for (const CLI::Option* option : command.get_options())
    page += option_entry(*option);
  page += ".SH EXIT STATUS\n" + plain(command.get_footer()) + "\n";
  if (!is_program)
    page += ".SH SEE ALSO\n" + bold(program.get_name()) + "(1)\n";
  return page;
}

std::string bash_completion(const CLI::App& program) {
  std::string commands, options, choices;
  for (const CLI::App* command : commands_of(program)) {
    commands += command->get_name() + " ";
    options += "    " + command->get_name() + ") words='" + options_of(*command) + "' ;;\n";
    choices += choice_branches(*command);
  }
  return "# Completion of " + program.get_name() +
         " for bash, made by its build.\n"
         "_prosup() {\n"
         "  local command=${COMP_WORDS[1]} current=${COMP_WORDS[COMP_CWORD]} words=\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    words='" +
         commands + options_of(program) +
         "'\n"
         "  elif [[ $current == -* ]]; then\n"
         "    case $command in\n" +
         options +
         "    esac\n"
         "  else\n"
         "    case \"$command ${COMP_WORDS[COMP_CWORD - 1]}\" in\n" +
         choices +
         "    esac\n"
         "  fi\n"
         "  # Without words, the names of files.\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "}\n"
         "complete -o default -F _prosup " +
         program.get_name() + "\n";
}

void write_manual(const std::filesystem::path& folder) {
  const CommandApp all;
  std::vector<const CLI::App*> pages = commands_of(all.app);
  pages.push_back(&all.app);
  std::filesystem::create_directories(folder / "man1");
  for (const CLI::App* page : pages)
    write_text_file(manual_page(all.app, *page),
                    folder / "man1" / (page_name(all.app, *page) + ".1"));
  std::filesystem::create_directories(folder / "completions");
  write_text_file(bash_completion(all.app), folder / "completions" / all.app.get_name());
}

} // namespace prosup::pipeline
