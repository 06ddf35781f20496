// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/initial_guess.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <complex>
#include <queue>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "disjoint_sets.hpp"
#include "falko_slam/geometry/angles.hpp"
#include "node_index.hpp"

namespace falko_slam {
namespace {

using Complex = std::complex<double>;

// A constraint in numbers.
struct Edge {
  std::size_t from, to;
  const GraphConstraint* constraint;
};

struct Graph {
  explicit Graph(const PoseGraph& graph) : poses(graph.nodes.size()), held(graph.nodes.size()) {
    const NodeIndex index(graph.nodes);
    DisjointSets parts(graph.nodes.size());
    for (const GraphConstraint& constraint : graph.constraints) {
      edges.push_back({index.at(constraint.from), index.at(constraint.to), &constraint});
      parts.join(edges.back().from, edges.back().to);
    }
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i] = graph.nodes[i].map_T_node;
    std::vector<bool> has_hold(poses.size());
    const auto hold_first = [&](std::size_t node) {
      if (has_hold[parts.find(node)]) return;
      has_hold[parts.find(node)] = held[node] = true;
    };
    for (const KeyframeId id : graph.fixed) hold_first(index.at(id));
    for (std::size_t i = 0; i < poses.size(); ++i) hold_first(i);
  }

  std::vector<Edge> edges;
  std::vector<Pose2> poses;
  std::vector<bool> held;
};

// The least-squares solution of z_to = factor z_from + offset over all edges, |factor| = 1, from
// the z of the nodes that are held. One pattern for all calls, one ordering.
class EdgeEquations {
 public:
  struct Term {
    double weight;
    Complex factor, offset;
  };

  explicit EdgeEquations(const Graph& graph) : graph_(graph) {
    Eigen::Index size = 0;
    for (const bool held : graph.held) column_.push_back(held ? -1 : size++);
    size_ = size;
  }

  void solve(const std::vector<Term>& terms, std::vector<Complex>& z) {
    using Matrix = Eigen::SparseMatrix<Complex>;
    std::vector<Eigen::Triplet<Complex>> entries;
    Eigen::VectorXcd right = Eigen::VectorXcd::Zero(size_);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const auto& [weight, factor, offset] = terms[k];
      const std::size_t i = graph_.edges[k].from, j = graph_.edges[k].to;
      const Eigen::Index from = column_[i], to = column_[j];
      if (from >= 0) {
        entries.emplace_back(from, from, weight);
        right[from] -= weight * std::conj(factor) * offset;
        if (to < 0) right[from] += weight * std::conj(factor) * z[j];
      }
      if (to >= 0) {
        entries.emplace_back(to, to, weight);
        right[to] += weight * offset;
        if (from < 0) right[to] += weight * factor * z[i];
      }
      if (from < 0 || to < 0) continue;
      const Complex coupling = -weight * (to > from ? factor : std::conj(factor));
      entries.emplace_back(std::max(from, to), std::min(from, to), coupling);
    }
    Matrix normal(size_, size_);
    normal.setFromTriplets(entries.begin(), entries.end());
    if (!analyzed_) solver_.analyzePattern(normal);
    analyzed_ = true;
    solver_.factorize(normal);
    if (solver_.info() != Eigen::Success) {
      throw std::runtime_error("initial guess: the constraints leave the graph loose");
    }
    const Eigen::VectorXcd solution = solver_.solve(right);
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (column_[i] >= 0) z[i] = solution[column_[i]];
    }
  }

 private:
  const Graph& graph_;
  std::vector<Eigen::Index> column_;  // -1: held
  Eigen::Index size_ = 0;
  bool analyzed_ = false;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver_;
};

double heading_weight(const GraphConstraint& constraint) {
  return std::max(constraint.information(2, 2), 1e-12);
}

// Chordal relaxation: e^(i theta_to) = e^(i theta_z) e^(i theta_from).
std::vector<double> chordal_headings(const Graph& graph, EdgeEquations& equations) {
  std::vector<EdgeEquations::Term> terms;
  for (const Edge& edge : graph.edges) {
    terms.push_back({heading_weight(*edge.constraint),
                     std::polar(1.0, edge.constraint->from_T_to.theta()), 0.0});
  }
  std::vector<Complex> directions;
  directions.reserve(graph.poses.size());
  for (const Pose2& pose : graph.poses) directions.push_back(std::polar(1.0, pose.theta()));
  equations.solve(terms, directions);
  std::vector<double> headings;
  headings.reserve(directions.size());
  for (const Complex& direction : directions) headings.push_back(std::arg(direction));
  return headings;
}

// Corrections of the headings that take up what the wrapped differences leave.
void refine_headings(const Graph& graph, EdgeEquations& equations, std::vector<double>& headings) {
  std::vector<EdgeEquations::Term> terms;
  for (const Edge& edge : graph.edges) {
    const double left =
        wrap_angle(headings[edge.from] + edge.constraint->from_T_to.theta() - headings[edge.to]);
    terms.push_back({heading_weight(*edge.constraint), 1.0, left});
  }
  std::vector<Complex> corrections(headings.size(), 0.0);
  equations.solve(terms, corrections);
  for (std::size_t i = 0; i < headings.size(); ++i) headings[i] += corrections[i].real();
}

// In the map.
Complex translation_of(const Edge& edge, const std::vector<double>& headings) {
  const Pose2& z = edge.constraint->from_T_to;
  return Complex(z.x(), z.y()) * std::polar(1.0, headings[edge.from]);
}

std::vector<Complex> positions(const Graph& graph, EdgeEquations& equations,
                               const std::vector<double>& headings) {
  std::vector<EdgeEquations::Term> terms;
  for (const Edge& edge : graph.edges) {
    const double weight = 0.5 * edge.constraint->information.topLeftCorner<2, 2>().trace();
    terms.push_back({std::max(weight, 1e-12), 1.0, translation_of(edge, headings)});
  }
  std::vector<Complex> result;
  for (const Pose2& pose : graph.poses) result.emplace_back(pose.x(), pose.y());
  equations.solve(terms, result);
  return result;
}

// The node that the tree has reached already, and the new one.
std::pair<std::size_t, std::size_t> ends_of(const Edge& edge, bool forward) {
  return forward ? std::make_pair(edge.from, edge.to) : std::make_pair(edge.to, edge.from);
}

// Breadth first from the nodes that are held; `forward` if an edge is walked as it points.
template <class Visit>
void for_each_tree_edge(const Graph& graph, const Visit& visit) {
  std::vector<std::vector<const Edge*>> edges_at(graph.poses.size());
  for (const Edge& edge : graph.edges) {
    edges_at[edge.from].push_back(&edge);
    edges_at[edge.to].push_back(&edge);
  }
  std::vector<bool> reached = graph.held;
  std::queue<std::size_t> open;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i]) open.push(i);
  }
  for (; !open.empty(); open.pop()) {
    for (const Edge* edge : edges_at[open.front()]) {
      const bool forward = edge->from == open.front();
      const std::size_t next = forward ? edge->to : edge->from;
      if (reached[next]) continue;
      reached[next] = true;
      visit(*edge, forward);
      open.push(next);
    }
  }
}

}  // namespace

std::vector<std::vector<KeyframeId>> connected_parts(const PoseGraph& graph) {
  const NodeIndex index(graph.nodes);
  DisjointSets sets(graph.nodes.size());
  for (const GraphConstraint& constraint : graph.constraints) {
    sets.join(index.at(constraint.from), index.at(constraint.to));
  }
  std::vector<std::vector<KeyframeId>> parts;
  std::unordered_map<std::size_t, std::size_t> number;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const auto [part, is_new] = number.emplace(sets.find(i), parts.size());
    if (is_new) parts.emplace_back();
    parts[part->second].push_back(graph.nodes[i].id);
  }
  return parts;
}

void require_connected(const PoseGraph& graph) {
  constexpr std::size_t kNamed = 5;  // more say no more
  const auto parts = connected_parts(graph);
  if (parts.size() <= 1) return;
  std::string text = "the graph falls into " + std::to_string(parts.size()) + " parts:";
  for (std::size_t i = 0; i < parts.size() && i < kNamed; ++i) {
    const auto [first, last] = std::minmax_element(parts[i].begin(), parts[i].end());
    text += (i > 0 ? "; " : " ") + std::to_string(parts[i].size()) + " nodes from " +
            std::to_string(first->value) + " to " + std::to_string(last->value);
  }
  throw std::invalid_argument(text + (parts.size() > kNamed ? "; ..." : ""));
}

ComputedGuess guess_from_constraints(const PoseGraph& given) {
  const Graph graph(given);
  EdgeEquations equations(graph);
  std::vector<double> headings = chordal_headings(graph, equations);
  refine_headings(graph, equations, headings);
  const std::vector<Complex> places = positions(graph, equations, headings);
  ComputedGuess result{given, given};
  for (std::size_t i = 0; i < places.size(); ++i) {
    result.likely.nodes[i].map_T_node = Pose2(places[i].real(), places[i].imag(), headings[i]);
  }
  for_each_tree_edge(graph, [&](const Edge& edge, bool forward) {
    const auto [near, far] = ends_of(edge, forward);
    const Complex step = translation_of(edge, headings);
    const Pose2& at = result.on_tree.nodes[near].map_T_node;
    const Complex place = Complex(at.x(), at.y()) + (forward ? step : -step);
    result.on_tree.nodes[far].map_T_node = Pose2(place.real(), place.imag(), headings[far]);
  });
  return result;
}

PoseGraph guess_from_spanning_tree(const PoseGraph& given) {
  PoseGraph result = given;
  for_each_tree_edge(Graph(given), [&](const Edge& edge, bool forward) {
    const auto [near, far] = ends_of(edge, forward);
    const Pose2& z = edge.constraint->from_T_to;
    result.nodes[far].map_T_node = result.nodes[near].map_T_node * (forward ? z : z.inverse());
  });
  return result;
}

GuessedGraph guess_poses(const PoseGraph& graph, Guess guess) {
  if (guess == Guess::kGiven) return {graph, false};
  ComputedGuess computed = guess_from_constraints(graph);
  if (guess == Guess::kBetter && chi2_of(graph) <= chi2_of(computed.likely)) return {graph, false};
  return {std::move(computed.on_tree), true};
}

}  // namespace falko_slam
