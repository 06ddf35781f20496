// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/pose_graph/g2o_file.hpp"

#include <algorithm>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "g2o_line.hpp"

namespace falko_slam {
namespace {

struct Reading {
  G2oFile file;
  std::unordered_map<KeyframeId, std::size_t> vertex_line;
  std::vector<std::size_t> edge_lines;
  std::unordered_map<KeyframeId, std::size_t> fix_line;
};

std::string name_of(KeyframeId id) { return "vertex " + std::to_string(id.value); }

std::string at_line(const std::string& path, std::size_t line) {
  return path + ": line " + std::to_string(line) + ": ";
}

void read_line(const std::string& line, std::size_t number, Reading& reading) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string::npos || line[begin] == '#') return;
  const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
  const std::string tag = line.substr(begin, end - begin), rest = line.substr(end);
  PoseGraph& graph = reading.file.graph;
  if (tag == "VERTEX_SE2" || tag == "VERTEX2") {
    const GraphNode node = parse_g2o_vertex(rest);
    const auto [earlier, is_new] = reading.vertex_line.emplace(node.id, number);
    if (!is_new) {
      throw std::runtime_error(name_of(node.id) + " is there already, from line " +
                               std::to_string(earlier->second));
    }
    graph.nodes.push_back(node);
  } else if (tag == "EDGE_SE2" || tag == "EDGE2") {
    graph.constraints.push_back(tag == "EDGE2" ? parse_toro_edge(rest) : parse_g2o_edge(rest));
    reading.edge_lines.push_back(number);
  } else if (tag == "FIX") {
    for (const KeyframeId id : parse_g2o_fix(rest)) {
      if (reading.fix_line.emplace(id, number).second) graph.fixed.push_back(id);
    }
  } else {
    ++reading.file.unknown_tags[tag];
  }
}

// The nodes of the edges, where the file has no others.
void add_nodes_of_edges(PoseGraph& graph) {
  std::vector<KeyframeId> ids;
  for (const GraphConstraint& edge : graph.constraints) {
    ids.push_back(edge.from);
    ids.push_back(edge.to);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  for (const KeyframeId id : ids) graph.nodes.push_back({id, Pose2()});
}

// Odometry joins nodes whose ids follow each other.
void name_kinds(PoseGraph& graph) {
  std::vector<KeyframeId> ids;
  for (const GraphNode& node : graph.nodes) ids.push_back(node.id);
  std::sort(ids.begin(), ids.end());
  for (GraphConstraint& edge : graph.constraints) {
    const auto lower = std::lower_bound(ids.begin(), ids.end(), std::min(edge.from, edge.to));
    const bool follows = lower + 1 != ids.end() && *(lower + 1) == std::max(edge.from, edge.to);
    edge.kind = follows ? ConstraintKind::kOdometry : ConstraintKind::kClosure;
  }
}

void check_names(const std::string& path, const Reading& reading) {
  std::unordered_map<KeyframeId, bool> known;
  for (const GraphNode& node : reading.file.graph.nodes) known[node.id] = true;
  const auto check = [&](KeyframeId id, std::size_t line) {
    if (known.count(id) == 0) {
      throw std::runtime_error(at_line(path, line) + name_of(id) + " is not in the file");
    }
  };
  for (std::size_t i = 0; i < reading.edge_lines.size(); ++i) {
    check(reading.file.graph.constraints[i].from, reading.edge_lines[i]);
    check(reading.file.graph.constraints[i].to, reading.edge_lines[i]);
  }
  for (const KeyframeId id : reading.file.graph.fixed) check(id, reading.fix_line.at(id));
}

std::string text_of(const PoseGraph& graph) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  const auto put = [&out](const Pose2& pose) {
    out << " " << pose.x() << " " << pose.y() << " " << pose.theta();
  };
  for (const GraphNode& node : graph.nodes) {
    out << "VERTEX_SE2 " << node.id.value;
    put(node.map_T_node);
    out << "\n";
  }
  for (const KeyframeId id : graph.fixed) out << "FIX " << id.value << "\n";
  for (const GraphConstraint& edge : graph.constraints) {
    out << "EDGE_SE2 " << edge.from.value << " " << edge.to.value;
    put(edge.from_T_to);
    for (Eigen::Index i = 0; i < 3; ++i) {
      for (Eigen::Index j = i; j < 3; ++j) out << " " << edge.information(i, j);
    }
    out << "\n";
  }
  return out.str();
}

}  // namespace

G2oFile read_g2o(const std::string& path) {
  LineReader in(path);
  Reading reading;
  std::string line;
  while (in.next(line)) {
    try {
      read_line(line, in.lines(), reading);
    } catch (const std::runtime_error& error) {
      in.fail(error.what());
    }
  }
  PoseGraph& graph = reading.file.graph;
  reading.file.has_poses = !graph.nodes.empty();
  if (!reading.file.has_poses) add_nodes_of_edges(graph);
  if (graph.nodes.empty()) throw std::runtime_error(path + ": holds no planar graph");
  check_names(path, reading);
  name_kinds(graph);
  return std::move(reading.file);
}

void write_g2o(const std::string& path, const PoseGraph& graph) {
  namespace io = boost::iostreams;
  const std::string ending = std::filesystem::path(path).extension().string();
  std::string packed;
  io::filtering_ostream out;
  if (ending == ".gz") out.push(io::gzip_compressor());
  if (ending == ".bz2") out.push(io::bzip2_compressor());
  out.push(io::back_inserter(packed));
  out << text_of(graph);
  out.reset();
  write_whole_file(path, packed);
}

}  // namespace falko_slam
