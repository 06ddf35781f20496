// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"

namespace {

// With the list of the commands where none was named, or none that there is.
std::string describe(const CLI::App* app, const CLI::Error& error) {
  const std::vector<std::string> unknown = app->remaining(true);
  std::string name = app->get_name();
  while (!app->get_subcommands().empty()) {
    app = app->get_subcommands().front();
    name += " " + app->get_name();
  }
  const auto commands = app->get_subcommands([](const CLI::App*) { return true; });
  const bool misspelt = !commands.empty() && !unknown.empty() && unknown.front()[0] != '-';
  std::string text =
      (misspelt ? unknown.front() + " is no command of " + name : std::string(error.what())) + "\n";
  for (const CLI::App* command : commands) {
    text += command == commands.front() ? name + " has: " : ", ";
    text += command->get_name();
  }
  return text + (commands.empty() ? "" : "\n") + name + " --help tells more.\n";
}

int run(int argc, char** argv) {
  CLI::App app("falko_slam on recorded data, faster than real time");
  app.name("falko");
  app.failure_message(describe);
  app.require_subcommand(0, 1);  // none is looked at below: here it would hide a misspelt one
  falko_slam::cli::add_calibrate(app);
  falko_slam::cli::add_convert(app);
  falko_slam::cli::add_detect(app);
  falko_slam::cli::add_evaluate(app);
  falko_slam::cli::add_localize(app);
  falko_slam::cli::add_map(app);
  falko_slam::cli::add_optimize(app);
  falko_slam::cli::add_parameters(app);
  falko_slam::cli::add_simulate(app);
  falko_slam::cli::add_slam(app);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) throw CLI::RequiredError::Subcommand(1);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0) throw std::runtime_error("standard output is full");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "falko: " << error.what() << "\n";
  }
  return 1;
}
