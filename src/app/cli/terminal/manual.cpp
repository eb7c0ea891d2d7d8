// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal/manual.h"

#include <functional>
#include <vector>

namespace tactooth {
namespace {

using Options = std::vector<const CLI::Option*>;
using Commands = std::vector<const CLI::App*>;

/// In the order of their declaration; --help comes last.
Options optionsOf(const CLI::App& command) {
    Options options = command.get_options([&](const CLI::Option* option) { return option != command.get_help_ptr(); });
    if (command.get_help_ptr() != nullptr) options.push_back(command.get_help_ptr());
    return options;
}

Commands commandsOf(const CLI::App& command) {
    return command.get_subcommands([](const CLI::App*) { return true; });
}

/// Visits each command with the words that select it: "bench contact".
void forEachCommand(const CLI::App& command, const std::string& words,
                    const std::function<void(const CLI::App&, const std::string& words)>& visit) {
    for (const CLI::App* each : commandsOf(command)) {
        const std::string path = words.empty() ? each->get_name() : words + ' ' + each->get_name();
        visit(*each, path);
        forEachCommand(*each, path, visit);
    }
}

/// The text between the braces of "MODE:{proxy,penalty}"; empty if any value is allowed.
std::string choicesOf(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const auto begin = type.find('{'), end = type.find('}');
    return begin == std::string::npos || end == std::string::npos ? "" : type.substr(begin + 1, end - begin - 1);
}

/// "--tooth,--case FILE", "[FILE]".
std::string usageOf(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    if (!option.nonpositional()) return option.get_name(true);
    std::string names;
    for (const std::string& name : option.get_snames()) names += (names.empty() ? "-" : ", -") + name;
    for (const std::string& name : option.get_lnames()) names += (names.empty() ? "--" : ", --") + name;
    return option.get_items_expected_max() == 0 || type.empty() ? names : names + ' ' + type;
}

/// The description as one sentence, with the additions from the declaration.
std::string meaningOf(const CLI::Option& option) {
    std::string text = option.get_description();
    if (!text.empty() && text.back() != '.') text += '.';
    if (option.get_required()) text += " Required.";
    return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// Escapes text for troff.
std::string troff(const std::string& text) {
    std::string safe = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

void addOptions(std::string& page, const CLI::App& command) {
    for (const CLI::Option* option : optionsOf(command)) {
        page += ".TP\n.B " + troff(usageOf(*option)) + '\n' + troff(meaningOf(*option)) + '\n';
    }
}

/// Escapes text for a table of Markdown.
std::string cell(const std::string& text) { return replaced(text, "|", "\\|"); }

void addTable(std::string& page, const CLI::App& command) {
    page += "| option | meaning |\n|---|---|\n";
    for (const CLI::Option* option : optionsOf(command))
        page += "| `" + cell(usageOf(*option)) + "` | " + cell(meaningOf(*option)) + " |\n";
}

}  // namespace

std::string manPage(const CLI::App& program, const std::string& version) {
    std::string page = ".TH TACTOOTH 1 \"\" \"Tactooth " + version + "\" \"User Commands\"\n.SH NAME\ntactooth \\- " +
                       troff("dental drilling simulator") +
                       "\n.SH SYNOPSIS\n.B tactooth\n[OPTIONS] [CASE]\n.br\n.B tactooth\nCOMMAND [OPTIONS]\n"
                       ".SH DESCRIPTION\n" +
                       troff(program.get_description()) + "\nWithout a command, it opens the window.\n.SH OPTIONS\n";
    addOptions(page, program);
    page += ".SH COMMANDS\n";
    forEachCommand(program, "", [&](const CLI::App& command, const std::string& words) {
        page += ".SS " + troff("tactooth " + words) + '\n' + troff(command.get_description()) + '\n';
        addOptions(page, command);
    });
    page +=
        ".SH EXIT STATUS\n.TP\n.B 0\nThe command has done its work.\n.TP\n.B 1\nThe command has worked, and its answer "
        "is no.\n.TP\n.B 2\nWrong usage, or an input or output that cannot be used.\n.SH ENVIRONMENT\n.TP\n.B "
        "TACTOOTH_DATA\nFolder with real teeth for measurements.\n";
    return page;
}

std::string bashCompletion(const CLI::App& program) {
    std::string cases;
    const auto addCase = [&](const CLI::App& command, const std::string& words) {
        std::string names;
        for (const CLI::App* each : commandsOf(command)) names += each->get_name() + ' ';
        std::string choices;
        for (const CLI::Option* option : optionsOf(command)) {
            for (const std::string& name : option->get_lnames()) names += "--" + name + ' ';
            const std::string values = replaced(choicesOf(*option), ",", " ");
            if (values.empty()) continue;
            if (!option->nonpositional()) names += values + ' ';
            for (const std::string& name : option->get_lnames())
                choices += "            --" + name + ") values=\"" + values + "\" ;;\n";
        }
        cases += "    \"" + words + "\")\n        words=\"" + names + "\"\n        case $before in\n" + choices +
                 "            *) ;;\n        esac ;;\n";
    };
    addCase(program, "");
    forEachCommand(program, "", addCase);
    return "# Completion of tactooth for bash; made by 'tactooth manual bash'.\n_tactooth() {\n"
           "  local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} path= words= values= i\n"
           "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "    case ${COMP_WORDS[i]} in -*) break ;; *) path+=${path:+ }${COMP_WORDS[i]} ;; esac\n"
           "  done\n"
           "  while [ -n \"$path\" ] && ! _tactooth_knows \"$path\"; do\n"
           "    case $path in *' '*) path=${path% *} ;; *) path= ;; esac\n"
           "  done\n"
           "  case $path in\n" +
           cases +
           "  esac\n"
           "  COMPREPLY=($(compgen -W \"${values:-$words}\" -- \"$now\"))\n"
           "  if [ -z \"$values\" ]; then COMPREPLY+=($(compgen -f -- \"$now\")); fi\n}\n"
           "_tactooth_knows() {\n  case $1 in\n" +
           [&] {
               std::string known;
               forEachCommand(program, "", [&](const CLI::App&, const std::string& words) {
                   known += "    \"" + words + "\") ;;\n";
               });
               return known;
           }() +
           "    *) return 1 ;;\n  esac\n}\ncomplete -o filenames -F _tactooth tactooth\n";
}

std::string commandsPage(const CLI::App& program) {
    std::string page =
        "# Commands and options\n\nThis page is made by `tactooth manual markdown` from the options that the program "
        "declares; do not edit it.\nExit codes: 0, the command has done its work; 1, it has worked and its answer is "
        "no; 2, wrong usage, or an input\nor output that cannot be used. In a type, `{a,b}` lists the values and "
        "`1 to 9` the range.\n\n## `tactooth [OPTIONS] [CASE]`\n\nOpens the window.\n\n";
    addTable(page, program);
    forEachCommand(program, "", [&](const CLI::App& command, const std::string& words) {
        page += "\n## `tactooth " + words + "`\n\n" + command.get_description() + "\n\n";
        addTable(page, command);
    });
    return page;
}

}  // namespace tactooth
