// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>

#include "commands.hpp"
#include "falko_slam/features/feature_extractor_fields.hpp"
#include "falko_slam/slam/slam_fields.hpp"

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
  CLI::App* verb =
      app.add_subcommand("parameters", "print parameters with their defaults, as YAML");
  auto what = std::make_shared<std::string>("features");
  verb->add_option("what", *what, "features (of the keypoint nodelet) or slam")
      ->check(CLI::IsMember({"features", "slam"}))
      ->capture_default_str();
  verb->callback([what] {
    YamlPrinter printer;
    if (*what == "slam") {
      const SlamParams params;
      visit_slam_fields(params, printer);
    } else {
      const FeatureExtractorParams params;
      visit_feature_extractor_fields(params, printer);
    }
  });
}

}  // namespace cli
}  // namespace falko_slam
