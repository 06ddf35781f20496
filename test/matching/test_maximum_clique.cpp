// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/matching/maximum_clique.hpp"

#include <gtest/gtest.h>

#include "support/seeds.hpp"

namespace falko_slam {
namespace {

BitGraph random_graph(std::size_t vertices, double density, std::mt19937_64& random) {
  BitGraph graph(vertices);
  for (std::size_t a = 0; a < vertices; ++a) {
    for (std::size_t b = a + 1; b < vertices; ++b) {
      if (test::uniform(random, 0.0, 1.0) < density) graph.add_edge(a, b);
    }
  }
  return graph;
}

// The parts have consecutive numbers; vertices of different parts are neighbours.
BitGraph multipartite(std::size_t parts, std::size_t size) {
  BitGraph graph(parts * size);
  for (std::size_t a = 0; a < graph.size(); ++a) {
    for (std::size_t b = a + 1; b < graph.size(); ++b) {
      if (a / size != b / size) graph.add_edge(a, b);
    }
  }
  return graph;
}

bool is_clique(const BitGraph& graph, const std::vector<std::size_t>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      if (vertices[i] >= vertices[j] || !graph.has_edge(vertices[i], vertices[j])) return false;
    }
  }
  return true;
}

// Every set of vertices of a graph of at most 64, one after the other.
std::size_t size_by_exhaustion(const BitGraph& graph, std::uint64_t candidates) {
  std::size_t best = 0;
  while (candidates != 0) {
    const auto vertex = static_cast<std::size_t>(__builtin_ctzll(candidates));
    candidates &= candidates - 1;
    best = std::max(best, 1 + size_by_exhaustion(graph, candidates & graph.row(vertex)[0]));
  }
  return best;
}

TEST(MaximumClique, IsAsLargeAsExhaustiveSearchFinds) {
  auto random = test::seeded_random();
  MaximumClique search;
  for (int run = 0; run < 1000; ++run) {
    const std::size_t vertices = 1 + static_cast<std::size_t>(run) % 20;
    const double density = 0.1 * (1 + run % 9);
    const BitGraph graph = random_graph(vertices, density, random);
    const CliqueResult result = search.search(graph);
    EXPECT_TRUE(result.proven);
    EXPECT_TRUE(is_clique(graph, result.vertices));
    EXPECT_EQ(result.vertices.size(),
              size_by_exhaustion(graph, (std::uint64_t{1} << vertices) - 1));
  }
}

TEST(MaximumClique, FindsThePlantedOneAcrossWords) {
  auto random = test::seeded_random();
  BitGraph graph = random_graph(300, 0.1, random);
  std::vector<std::size_t> planted;
  for (std::size_t v = 5; v < 300; v += 20) planted.push_back(v);
  for (const std::size_t a : planted) {
    for (const std::size_t b : planted) {
      if (a != b) graph.add_edge(a, b);
    }
  }
  const CliqueResult result = MaximumClique().search(graph);
  EXPECT_TRUE(result.proven);
  EXPECT_EQ(result.vertices, planted);
}

TEST(MaximumClique, OfACompleteGraphIsAll) {
  for (const std::size_t n : {1, 2, 63, 64, 65, 130}) {
    EXPECT_EQ(MaximumClique().search(multipartite(n, 1)).vertices.size(), n);
  }
}

TEST(MaximumClique, OfNoEdgesIsOneVertexAndOfNothingNone) {
  EXPECT_EQ(MaximumClique().search(BitGraph(70)).vertices.size(), 1U);
  EXPECT_TRUE(MaximumClique().search(BitGraph()).vertices.empty());
  EXPECT_TRUE(MaximumClique().search(BitGraph()).proven);
}

TEST(MaximumClique, TakesOneVertexOfEachPart) {
  const BitGraph graph = multipartite(7, 11);
  const CliqueResult result = MaximumClique().search(graph);
  EXPECT_TRUE(is_clique(graph, result.vertices));
  EXPECT_EQ(result.vertices.size(), 7U);
}

// Parts of three: 3^20 maximal cliques, all of them maximum.
TEST(MaximumClique, ProvesAMoonMoserGraphAtOnce) {
  const CliqueResult result = MaximumClique().search(multipartite(20, 3));
  EXPECT_TRUE(result.proven);
  EXPECT_EQ(result.vertices.size(), 20U);
  EXPECT_LT(result.nodes, 100U);
}

TEST(MaximumClique, ReturnsNothingThatIsNotLargerThanAsked) {
  const BitGraph graph = multipartite(7, 3);
  EXPECT_EQ(MaximumClique().search(graph, {6}).vertices.size(), 7U);
  const CliqueResult none = MaximumClique().search(graph, {7});
  EXPECT_TRUE(none.vertices.empty());
  EXPECT_TRUE(none.proven);
}

TEST(MaximumClique, SaysWhenTheNodesRanOut) {
  auto random = test::seeded_random();
  const BitGraph graph = random_graph(120, 0.7, random);
  const CliqueResult result = MaximumClique().search(graph, {0, 50});
  EXPECT_FALSE(result.proven);
  EXPECT_EQ(result.nodes, 50U);
  EXPECT_FALSE(result.vertices.empty());
  EXPECT_TRUE(is_clique(graph, result.vertices));
  EXPECT_FALSE(MaximumClique().search(graph, {0, 0}).proven);
}

TEST(MaximumClique, RemembersNothing) {
  auto random = test::seeded_random();
  const BitGraph large = random_graph(150, 0.3, random);
  const BitGraph small = random_graph(20, 0.5, random);
  MaximumClique search;
  const CliqueResult first = search.search(small);
  search.search(large);
  const CliqueResult again = search.search(small);
  EXPECT_EQ(first.vertices, again.vertices);
  EXPECT_EQ(first.nodes, again.nodes);
}

}  // namespace
}  // namespace falko_slam
