// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/g2o_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "support/simulated_graphs.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

constexpr char kVertices[] = "VERTEX_SE2 1 0 0 0\nVERTEX_SE2 2 1 0 0.5\n";

class G2oFileTest : public ::testing::Test {
 protected:
  std::string complaint(const std::string& text, const std::string& name = "bad.g2o") {
    const std::string path = folder_.write(name, text);
    try {
      read_g2o(path);
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      return what.rfind(path + ": ", 0) == 0 ? what.substr(path.size() + 2) : "no name: " + what;
    }
    return "none";
  }

  test::TemporaryFolder folder_;
};

TEST_F(G2oFileTest, BringsBackTheSameBits) {
  auto random = test::seeded_random();
  PoseGraph graph = test::drive_grid(100, {}, random).graph;
  graph.fixed = {{3}, {4}};
  for (GraphConstraint& constraint : graph.constraints) {
    constraint.information = constraint.information * (1.0 / 3.0);
  }
  for (const char* name : {"a.g2o", "a.g2o.gz", "a.g2o.bz2"}) {
    write_g2o(folder_.file(name), graph);
    const PoseGraph back = read_g2o(folder_.file(name)).graph;

    ASSERT_EQ(back.nodes.size(), graph.nodes.size());
    ASSERT_EQ(back.constraints.size(), graph.constraints.size());
    EXPECT_EQ(back.fixed, graph.fixed);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      const Pose2 &a = graph.nodes[i].map_T_node, &b = back.nodes[i].map_T_node;
      EXPECT_EQ(a.translation(), b.translation());
      EXPECT_EQ(a.theta(), b.theta());
    }
    for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
      const GraphConstraint &a = graph.constraints[i], &b = back.constraints[i];
      EXPECT_EQ(a.from, b.from);
      EXPECT_EQ(a.to, b.to);
      EXPECT_EQ(a.kind, b.kind);
      EXPECT_EQ(a.from_T_to.translation(), b.from_T_to.translation());
      EXPECT_EQ(a.from_T_to.theta(), b.from_T_to.theta());
      EXPECT_EQ(a.information, b.information);
    }
  }
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"a.g2o", "a.g2o.gz", "a.g2o.bz2"}));
}

TEST_F(G2oFileTest, KnowsTheOrderOfToro) {
  const G2oFile g2o = read_g2o(
      folder_.write("a.g2o", std::string(kVertices) + "EDGE_SE2 1 2 1 2 0.3  10 1 2 11 3 12\r\n"));
  const G2oFile toro = read_g2o(folder_.write(
      "a.graph", "VERTEX2 1 0 0 0\nVERTEX2 2 1 0 0.5\nEDGE2 1 2 1 2 0.3  10 1 11 12 2 3\n"));
  EXPECT_EQ(g2o.graph.constraints[0].information, toro.graph.constraints[0].information);
  EXPECT_EQ(g2o.graph.constraints[0].information(1, 2), 3.0);
  EXPECT_EQ(toro.graph.nodes[1].map_T_node.theta(), 0.5);
}

TEST_F(G2oFileTest, TakesEdgesAlone) {
  const G2oFile file = read_g2o(folder_.write(
      "a.g2o",
      "# no poses\n\nEDGE_SE2 7 30 1 0 0 1 0 0 1 0 1\nEDGE_SE2 30 9 1 0 0 1 0 0 1 0 1\n"
      "FIX 9\nVERTEX_XY 3 4 5\nVERTEX_XY 5 5 5\n"));
  EXPECT_FALSE(file.has_poses);
  ASSERT_EQ(file.graph.nodes.size(), 3U);
  EXPECT_EQ(file.graph.nodes[1].id, KeyframeId{9});
  EXPECT_EQ(file.graph.fixed, (std::vector<KeyframeId>{{9}}));
  EXPECT_EQ(file.graph.constraints[0].kind, ConstraintKind::kClosure);
  EXPECT_EQ(file.graph.constraints[1].kind, ConstraintKind::kOdometry);
  EXPECT_EQ(file.unknown_tags, (std::map<std::string, std::size_t>{{"VERTEX_XY", 2}}));
}

TEST_F(G2oFileTest, NamesLineAndFault) {
  const std::string vertices = kVertices;
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 1 0 0 0\n"),
            "line 3: vertex 1 is there already, from line 1");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 3 0 0\n"), "line 3: ends where a number is wanted");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 3 0 0 0 0\n"),
            "line 3: \"0\" where the end of the line is wanted");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 -3 0 0 0\n"),
            "line 3: \"-3\" where a node's number is wanted");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 3 0 nan 0\n"),
            "line 3: \"nan\" where a finite number is wanted");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 3 0 1e999 0\n"),
            "line 3: \"1e999\" where a finite number is wanted");
  EXPECT_EQ(complaint(vertices + "VERTEX_SE2 3 0 1,5 0\n"),
            "line 3: \"1,5\" where a number is wanted");
  EXPECT_EQ(complaint(vertices + "\nEDGE_SE2 1 5 0 0 0 1 0 0 1 0 1\n"),
            "line 4: vertex 5 is not in the file");
  EXPECT_EQ(complaint(vertices + "FIX 8\n"), "line 3: vertex 8 is not in the file");
  EXPECT_EQ(complaint(vertices + "EDGE_SE2 2 2 0 0 0 1 0 0 1 0 1\n"),
            "line 3: an edge of a node with itself");
  EXPECT_NE(complaint(vertices + "EDGE_SE2 1 2 0 0 0 1 0 0 -1 0 1\n")
                .find("line 3: information [1, 0, 0; 0, -1, 0; 0, 0, 1]: must be positive"),
            std::string::npos);
  EXPECT_EQ(complaint("VERTEX_XY 1 2 3\n"), "holds no planar graph");
  EXPECT_EQ(complaint(""), "holds no planar graph");
}

TEST_F(G2oFileTest, NamesFilesThatCannotBeReadOrWritten) {
  EXPECT_THROW(read_g2o(folder_.file("none.g2o")), std::runtime_error);
  EXPECT_THROW(write_g2o(folder_.file("none/a.g2o"), {}), std::runtime_error);
  auto random = test::seeded_random();
  write_g2o(folder_.file("a.g2o.gz"), test::drive_grid(100, {}, random).graph);
  std::ifstream in(folder_.file("a.g2o.gz"), std::ios::binary);
  const std::string packed{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  std::ofstream(folder_.file("cut.g2o.gz"), std::ios::binary)
      << packed.substr(0, packed.size() / 2);
  EXPECT_THROW(read_g2o(folder_.file("cut.g2o.gz")), std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
