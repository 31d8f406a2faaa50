#include "usage_message.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "similar_word.hpp"

namespace pardel::cli {
namespace {

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string similar = similar_word(word, known);
  return similar.empty() ? similar : fmt::format("; did you mean '{}'?", similar);
}

std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

bool has_name(const AbsentOption& option, const std::string& name) {
  return fmt::format(",{},", option.names).find("," + name + ",") != std::string::npos;
}

/// The message for an argument that the command does not know; empty if there is none. An unknown option comes first,
/// because its value is then an unknown argument, too.
std::string unknown_argument(const CLI::App& command, std::span<const AbsentOption> absent) {
  const std::vector<std::string> extras = command.remaining();
  const auto option = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with('-'); });
  if (option != extras.end()) {
    const std::string name = option->substr(0, option->find('='));
    for (const AbsentOption& other : absent)
      if (other.command == command.get_name() && has_name(other, name))
        return fmt::format("there is no option '{}': {}", name, other.why);
    return fmt::format("there is no option '{}'{}", name, suggestion(name, long_options(command)));
  }
  return extras.empty() ? std::string() : fmt::format("unexpected argument '{}'", extras.front());
}

}  // namespace

std::string usage_message(const CLI::App* program, const CLI::Error& error, std::span<const AbsentOption> absent) {
  std::string name = program->get_name();
  std::string unknown;
  for (const CLI::App* command : program->get_subcommands()) {
    name += ' ' + command->get_name();
    unknown = unknown_argument(*command, absent);
  }
  return fmt::format("{}: {} (see '{} --help')\n", name, unknown.empty() ? error.what() : unknown, name);
}

std::string unknown_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return fmt::format("there is no command '{}'{} (see 'pardel --help')", word, suggestion(word, names));
}

}  // namespace pardel::cli
