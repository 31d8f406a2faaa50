// The format of --help: each option with its kind of value, then its text; `help COMMAND`.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

namespace pardel::cli {

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(28); }

  std::string make_option_opts(const CLI::Option* option) const override {
    const std::string kind = option->get_type_name();
    return (kind.empty() ? "" : ' ' + kind) +
           (option->get_required() && !option->get_positional() ? " (required)" : "");
  }
};

/// `help COMMAND` is another form of `COMMAND --help`.
inline void expand_help(std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front() != "help") return;
  arguments.erase(arguments.begin());
  arguments.push_back("--help");
}

}  // namespace pardel::cli
