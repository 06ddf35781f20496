// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/yaml_parameters.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

using XmlRpc::XmlRpcValue;

std::string complaint_of(const std::string& path) {
  try {
    read_parameter_file(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ParameterFile, BecomesWhatRosparamWouldLoad) {
  const test::TemporaryFolder folder;
  XmlRpcValue tree = read_parameter_file(
      folder.write("a.yaml",
                   "flag: true\ncount: 3\nlength: 0.5\nname: hall\nquoted: \"3\"\ngroup: {a: 1}\n"
                   "empty: {}\nlist: [1, 2]\nnothing: \"\"\n"));
  EXPECT_TRUE(static_cast<bool>(tree["flag"]));
  EXPECT_EQ(static_cast<int>(tree["count"]), 3);
  EXPECT_EQ(static_cast<double>(tree["length"]), 0.5);
  EXPECT_EQ(static_cast<std::string>(tree["name"]), "hall");
  EXPECT_EQ(static_cast<std::string>(tree["quoted"]), "3");
  EXPECT_EQ(static_cast<std::string>(tree["nothing"]), "");
  EXPECT_EQ(static_cast<int>(tree["group"]["a"]), 1);
  EXPECT_EQ(tree["empty"].getType(), XmlRpcValue::TypeStruct);
  EXPECT_EQ(tree["list"].size(), 2);
}

TEST(ParameterFile, IsNamedWhereItIsNone) {
  const test::TemporaryFolder folder;
  const std::string missing = folder.file("missing.yaml");
  EXPECT_EQ(complaint_of(missing), missing + ": cannot be read");
  const std::string text = folder.write("text.yaml", "just words");
  EXPECT_EQ(complaint_of(text), text + ": holds no parameters (name: value)");
  const std::string broken = folder.write("broken.yaml", "a: 1\nb: [1, 2\n");
  EXPECT_NE(complaint_of(broken).find(broken + ": "), std::string::npos);
  EXPECT_NE(complaint_of(broken).find("line 3"), std::string::npos) << complaint_of(broken);
}

// Ten lines of aliases that stand for 10^10 values.
TEST(ParameterFile, RefusesMoreThanParametersEverAre) {
  const test::TemporaryFolder folder;
  std::string aliases = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    aliases += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int j = 1; j < 10; ++j) aliases += ", " + before;
    aliases += "]\n";
  }
  const std::string many = folder.write("many.yaml", aliases);
  EXPECT_NE(complaint_of(many).find("stands for too many values"), std::string::npos);
  const std::string deep =
      folder.write("deep.yaml", "a: " + std::string(100, '[') + std::string(100, ']') + "\n");
  EXPECT_EQ(complaint_of(deep), deep + ": line 1: goes too deep");
  const std::string big = folder.write("big.yaml", "a: " + std::string(2000000, 'x') + "\n");
  EXPECT_EQ(complaint_of(big), big + ": is too big for a file of parameters");
}

}  // namespace
}  // namespace falko_slam
