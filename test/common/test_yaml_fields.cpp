// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/common/yaml_fields.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

enum class Mode { kSlow, kFast };
const EnumNames<Mode> kModes = {{"slow", Mode::kSlow}, {"fast", Mode::kFast}};

struct Settings {
  double length = 1.5;
  bool round = false;
  int shift = -2;
  std::uint32_t ticks = 7;
  std::size_t count = 3;
  std::string frame = "laser";
  Mode mode = Mode::kSlow;
};

template <class Visitor>
void visit_settings(Settings& settings, Visitor& visitor) {
  visitor.field("length", settings.length);
  visitor.begin("how");
  visitor.field("round", settings.round);
  visitor.choice("mode", settings.mode, kModes);
  visitor.begin("deeper");
  visitor.field("shift", settings.shift);
  visitor.end();
  visitor.end();
  visitor.field("ticks", settings.ticks);
  visitor.field("count", settings.count);
  visitor.field("frame", settings.frame);
}

Settings settings_in(const std::string& text) {
  YamlFields fields = YamlFields::of_text(text, "c.yaml");
  Settings settings;
  visit_settings(settings, fields);
  fields.refuse_unknown();
  return settings;
}

std::string complaint(const std::function<void()>& read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "none";
}

std::string complaint_about(const std::string& text) {
  return complaint([&] { settings_in(text); });
}

const char* const kAll =
    "length: 2.5\nhow:\n  round: true\n  mode: fast\n  deeper: {shift: 4}\n"
    "ticks: 4294967295\ncount: 12\nframe: base\n";

TEST(YamlFields, VisitsTheFieldsOfAFile) {
  const Settings settings = settings_in(kAll);
  EXPECT_EQ(settings.length, 2.5);
  EXPECT_TRUE(settings.round);
  EXPECT_EQ(settings.mode, Mode::kFast);
  EXPECT_EQ(settings.shift, 4);
  EXPECT_EQ(settings.ticks, 4294967295U);
  EXPECT_EQ(settings.count, 12U);
  EXPECT_EQ(settings.frame, "base");
}

TEST(YamlFields, LeavesWhatIsNotInTheFile) {
  for (const char* text : {"count: 3", "{}", "how:", "how: {deeper: {}}"}) {
    const Settings settings = settings_in(text);
    EXPECT_EQ(settings.length, 1.5);
    EXPECT_FALSE(settings.round);
    EXPECT_EQ(settings.mode, Mode::kSlow);
    EXPECT_EQ(settings.shift, -2);
    EXPECT_EQ(settings.ticks, 7U);
    EXPECT_EQ(settings.count, 3U);
    EXPECT_EQ(settings.frame, "laser");
  }
}

TEST(YamlFields, MayRequireEveryField) {
  const auto read = [](const std::string& text) {
    return complaint([&] {
      YamlFields fields = YamlFields::of_text(text, "c.yaml");
      fields.require_fields();
      Settings settings;
      visit_settings(settings, fields);
    });
  };
  EXPECT_EQ(read(kAll), "none");
  EXPECT_EQ(read("length: 1\nhow:\n  round: true\n"), "c.yaml: line 2: how: mode is missing");
  EXPECT_EQ(read("# nothing else\nlength: 1"), "c.yaml: line 2: how: round is missing");
}

TEST(YamlFields, RefusesValuesWithFileLineAndPath) {
  EXPECT_EQ(complaint_about("length: long"), "c.yaml: line 1: length: must be a number");
  EXPECT_EQ(complaint_about("\nhow:\n  round: 2"),
            "c.yaml: line 3: how.round: must be true or false");
  EXPECT_EQ(complaint_about("how: {mode: x}"), "c.yaml: line 1: how.mode: must be slow or fast");
  EXPECT_EQ(
      complaint_about("how:\n  deeper:\n    shift: 9999999999"),
      "c.yaml: line 3: how.deeper.shift: must be a whole number in [-2147483648, 2147483647]");
  EXPECT_EQ(complaint_about("ticks: -1"),
            "c.yaml: line 1: ticks: must be a whole number in [0, 4294967295]");
  EXPECT_EQ(complaint_about("count: -1"),
            "c.yaml: line 1: count: must be a whole number of at least 0");
  EXPECT_EQ(complaint_about("frame: [a]"), "c.yaml: line 1: frame: must be a text");
  EXPECT_EQ(complaint_about("\nhow: round"),
            "c.yaml: line 2: how: must be a group of fields (name: value)");
}

TEST(YamlFields, RefusesUnknownKeysAndNamesTheKnown) {
  EXPECT_EQ(
      complaint_about("length: 1\nlenght: 2"),
      "c.yaml: line 2: lenght: nobody knows this; known are length, how, ticks, count and frame");
  EXPECT_EQ(complaint_about("how:\n  deeper:\n    shift: 1\n    x: {y: 1}"),
            "c.yaml: line 4: how.deeper.x: nobody knows this; known are shift");
  EXPECT_EQ(complaint_about("<<: {a: 1}").find("c.yaml: line 1: <<: nobody knows this"), 0U);
}

TEST(YamlFields, RefusesDuplicateKeys) {
  EXPECT_EQ(complaint_about("how:\n  round: true\n  mode: fast\n  round: true"),
            "c.yaml: line 4: round stands here twice, first in line 2");
}

TEST(YamlFields, FindsWhatIsThere) {
  const YamlFields fields = YamlFields::of_text("b: 1\na: {c: x}\n", "c.yaml");
  EXPECT_TRUE(fields.has("b"));
  EXPECT_FALSE(fields.has("c"));
  EXPECT_FALSE(fields.find("c"));
  EXPECT_EQ(YamlFields(fields.at("a")).at("c").text(), "x");
  EXPECT_EQ(complaint([&] { fields.at("c"); }), "c.yaml: line 1: c is missing");
  EXPECT_EQ(complaint([&] { YamlFields(fields.at("a")).at("d"); }),
            "c.yaml: line 2: a: d is missing");
  const auto all = fields.all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].first, "b");
  EXPECT_EQ(all[1].first, "a");
}

TEST(YamlFields, ChoosesTheOnlyOneOfSomeKeys) {
  const auto choose = [](const std::string& text) {
    return YamlFields::of_text(text, "c.yaml").one_of({"wall", "box", "column"});
  };
  EXPECT_EQ(choose("{box: 1, surface: 2}"), "box");
  EXPECT_EQ(complaint([&] { choose("{surface: 1}"); }),
            "c.yaml: line 1: must have one of wall, box and column");
  EXPECT_EQ(complaint([&] { choose("{wall: 1, column: 2}"); }),
            "c.yaml: line 1: has wall and column, must have one of them only");
}

TEST(YamlFields, SayWhereAFieldStandsThatACheckRefuses) {
  const auto refuse = [](const std::string& text, const std::string& what) {
    return complaint([&] {
      YamlFields fields = YamlFields::of_text(text, "c.yaml");
      fields.begin("laser");
      fields.check([&] { throw std::invalid_argument(what); });
    });
  };
  const std::string text = "name: x\nlaser:\n  noise: -1\n  wheel:\n    scale: 0\n";
  EXPECT_EQ(refuse(text, "noise = -1: is bad"), "c.yaml: line 3: laser.noise = -1: is bad");
  EXPECT_EQ(refuse(text, "wheel.scale = 0"), "c.yaml: line 5: laser.wheel.scale = 0");
  EXPECT_EQ(refuse(text, "wheel.length = 0"), "c.yaml: line 4: laser.wheel.length = 0");
  EXPECT_EQ(refuse(text, "beams = 0"), "c.yaml: line 2: laser.beams = 0");
  EXPECT_EQ(refuse("name: x", "beams = 0"), "c.yaml: line 1: laser.beams = 0");
}

TEST(YamlFields, RefusesFilesThatAreNoGroupOfFields) {
  EXPECT_EQ(complaint_about(""), "c.yaml: is empty");
  EXPECT_EQ(complaint_about("# nothing\n"), "c.yaml: is empty");
  EXPECT_EQ(complaint_about("--- \n"), "c.yaml: is empty");
  EXPECT_EQ(complaint_about("- 1"), "c.yaml: line 1: must be a group of fields (name: value)");
  EXPECT_EQ(complaint_about("some words"),
            "c.yaml: line 1: must be a group of fields (name: value)");
  EXPECT_EQ(complaint_about("count: 1\n---\ncount: 2"), "c.yaml: line 2: a second document begins");
}

TEST(YamlFields, RefusesBrokenAndUncommonYaml) {
  const auto line = [](const std::string& text, int number, const std::string& what = "") {
    const std::string error = complaint_about(text);
    EXPECT_EQ(error.find("c.yaml: line " + std::to_string(number) + ": "), 0U) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  line("count: 1\nhow: [1, 2\nticks: 3\n", 3);
  line("count: 1\n\tticks: 3\n", 2);
  line("count: \"abc", 1);
  line("count: 1\n  ticks: 2\n", 2);
  line("a: &x [1]\nb: *x\n", 2, "aliases");
  line("a: *unknown\n", 1);
  line("count: !!int 3", 1, "tags");
  line("how: !wheel {round: true}", 1, "tags");
  line("? [1, 2]\n: 3", 1, "keys must be texts");
  line("{{a: 1}: 3}", 1, "keys must be texts");
  line(": 3", 1, "a key is empty");
  line("\x80\x81\xFE", 1);
}

TEST(YamlFields, RefusesWhatIsTooDeepOrTooBig) {
  const auto says = [](const std::string& text, const std::string& what) {
    const std::string error = complaint_about(text);
    EXPECT_EQ(error.find("c.yaml: "), 0U) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  constexpr std::size_t kDeep = 50000;
  says("a: " + std::string(kDeep, '['), "line 1: ");
  says("a: " + std::string(kDeep, '[') + std::string(kDeep, ']'), "line 1: goes too deep");
  std::string braces = "a: ";
  for (std::size_t i = 0; i < kDeep; ++i) braces += "{a: ";
  says(braces, "line 1: goes too deep");
  std::string stairs;
  for (std::size_t i = 0; i < 200; ++i) stairs += std::string(i, ' ') + "a:\n";
  says(stairs, "goes too deep");
  std::string dashes = "a:\n";
  for (std::size_t i = 0; i < kDeep; ++i) dashes += "- ";
  says(dashes, "goes too deep");
  std::string many = "a: [";
  for (std::size_t i = 0; i < 300000; ++i) many += "1, ";
  says(many + "1]", "line 1: holds too many values");
  says("a: " + std::string(std::size_t{2} << 20U, 'x'), "is too big for a YAML file");
}

TEST(YamlFields, ShortensAndCleansWhatItRepeats) {
  const std::string error = complaint_about(std::string(100, 'k') + ": 1");
  EXPECT_NE(error.find(std::string(60, 'k') + "...: nobody"), std::string::npos) << error;
  EXPECT_NE(complaint_about("\"a\\eb\": 1").find("line 1: a?b: nobody"), std::string::npos);
}

TEST(YamlFields, NamesTheFileThatItReads) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("laser.yaml", "count: 1\nlenght: 2\n");
  EXPECT_EQ(YamlFields(path).at("count").integer(), 1);
  EXPECT_EQ(complaint([&] { YamlFields(path).at("lenght").flag(); }),
            path + ": line 2: lenght: must be true or false");
  const std::string missing = folder.file("none.yaml");
  EXPECT_EQ(complaint([&] { YamlFields fields(missing); }),
            missing + ": cannot be read: No such file or directory");
  EXPECT_EQ(complaint([&] { YamlFields fields(folder.path()); }),
            folder.path() + ": cannot be read: Is a directory");
  EXPECT_EQ(complaint([&] { YamlFields fields("/dev/zero"); }),
            "/dev/zero: is too big for a YAML file");
  EXPECT_EQ(complaint([&] { YamlFields fields("/dev/null"); }), "/dev/null: is empty");
}

}  // namespace
}  // namespace falko_slam
