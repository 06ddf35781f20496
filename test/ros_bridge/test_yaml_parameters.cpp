// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/ros_bridge/yaml_parameters.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace falko_slam
