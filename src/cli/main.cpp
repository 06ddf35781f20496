// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>

#include "commands.hpp"

namespace {

int run(int argc, char** argv) {
  CLI::App app("falko_slam on recorded data, faster than real time");
  app.name("falko");
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
