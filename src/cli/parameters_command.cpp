// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "commands.hpp"
#include "falko_slam/features/feature_extractor_fields.hpp"

namespace falko_slam {
namespace cli {
namespace {

// A visitor of parameter fields that prints them as YAML.
class YamlPrinter {
 public:
  void begin(const char* group) {
    std::cout << group << ":\n";
    indent_ = "  ";
  }
  void end() { indent_ = ""; }
  template <class Value>
  void field(const char* name, const Value& value) {
    std::cout << std::boolalpha << indent_ << name << ": " << value << "\n";
  }
  template <class Enum>
  void choice(const char* name, const Enum& value, const EnumNames<Enum>& names) {
    field(name, name_of(value, names));
  }

 private:
  const char* indent_ = "";
};

}  // namespace

void add_parameters(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("parameters", "print all parameters with their defaults");
  verb->callback([] {
    YamlPrinter printer;
    const FeatureExtractorParams params;
    visit_feature_extractor_fields(params, printer);
  });
}

}  // namespace cli
}  // namespace falko_slam
