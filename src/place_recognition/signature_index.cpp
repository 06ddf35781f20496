// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/place_recognition/signature_index.hpp"

#include <limits>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "signature_file.hpp"
#include "signature_tree.hpp"

namespace falko_slam {
namespace {

constexpr std::size_t kNewcomers = 128;  // so many are looked through one by one
constexpr std::size_t kAmongNewcomers = std::numeric_limits<std::size_t>::max();

struct Place {
  std::size_t tree = kAmongNewcomers;
  std::size_t slot = 0;
};

}  // namespace

struct SignatureIndex::Forest {
  Forest(int rows, int columns) { newcomers.rows = rows, newcomers.columns = columns; }

  void require_shape(const Signature& signature) const {
    if (signature.rows == newcomers.rows && signature.columns == newcomers.columns) return;
    throw std::invalid_argument("signature of " + std::to_string(signature.rows) + " x " +
                                std::to_string(signature.columns) + " cells in an index of " +
                                std::to_string(newcomers.rows) + " x " +
                                std::to_string(newcomers.columns));
  }

  SignatureBlock empty_block() const {
    SignatureBlock block;
    block.rows = newcomers.rows;
    block.columns = newcomers.columns;
    return block;
  }

  void add(KeyframeId id, const Signature& signature) {
    places[id] = {kAmongNewcomers, newcomers.size()};
    newcomers.add(id, signature);
    if (newcomers.size() >= kNewcomers) grow();
  }

  // Makes one tree of the newcomers and of all trees that are not much larger; the dead go.
  void grow() {
    SignatureBlock together = std::exchange(newcomers, empty_block());
    while (!trees.empty() && trees.back().block.size() < 2 * together.size()) {
      for (std::size_t i = 0; i < trees.back().block.size(); ++i) {
        together.add(trees.back().block, i);
      }
      trees.pop_back();
    }
    SignatureTree tree(together);
    dead -= together.size() - tree.block.size();
    for (std::size_t i = 0; i < tree.block.size(); ++i) {
      places[tree.block.ids[i]] = {trees.size(), i};
    }
    if (tree.block.size() > 0) trees.push_back(std::move(tree));
  }

  void remove(const Place& place) {
    SignatureBlock& block = place.tree == kAmongNewcomers ? newcomers : trees[place.tree].block;
    block.removed[place.slot] = true;
    if (++dead <= places.size() + kNewcomers) return;
    while (!trees.empty()) {
      for (std::size_t i = 0; i < trees.back().block.size(); ++i) {
        newcomers.add(trees.back().block, i);
      }
      trees.pop_back();
    }
    grow();
  }

  template <class Visit>
  void for_each(Visit visit) const {
    const auto walk = [&](const SignatureBlock& block) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        if (!block.removed[i]) visit(block, i);
      }
    };
    for (const SignatureTree& tree : trees) walk(tree.block);
    walk(newcomers);
  }

  std::vector<SignatureTree> trees;  // the largest first
  SignatureBlock newcomers;
  std::unordered_map<KeyframeId, Place> places;  // of the living
  std::size_t dead = 0;
};

SignatureIndex::SignatureIndex(int rows, int columns)
    : forest_(std::make_unique<Forest>(rows, columns)) {
  if (rows >= 1 && rows <= 64 && columns >= 1) return;
  throw std::invalid_argument("index of signatures of " + std::to_string(rows) + " x " +
                              std::to_string(columns) + " cells: must have 1 to 64 rows");
}

SignatureIndex::~SignatureIndex() = default;
SignatureIndex::SignatureIndex(SignatureIndex&&) noexcept = default;
SignatureIndex& SignatureIndex::operator=(SignatureIndex&&) noexcept = default;

void SignatureIndex::add(KeyframeId id, const Signature& signature) {
  forest_->require_shape(signature);
  if (contains(id)) {
    throw std::invalid_argument("keyframe " + std::to_string(id.value) +
                                " is in the index already");
  }
  forest_->add(id, signature);
}

bool SignatureIndex::remove(KeyframeId id) {
  const auto found = forest_->places.find(id);
  if (found == forest_->places.end()) return false;
  const Place place = found->second;
  forest_->places.erase(found);
  forest_->remove(place);
  return true;
}

bool SignatureIndex::contains(KeyframeId id) const { return forest_->places.count(id) > 0; }
std::size_t SignatureIndex::size() const { return forest_->places.size(); }
int SignatureIndex::rows() const { return forest_->newcomers.rows; }
int SignatureIndex::columns() const { return forest_->newcomers.columns; }

std::vector<SignatureMatch> SignatureIndex::nearest(const Signature& query, std::size_t count,
                                                    const Admission& admits) const {
  forest_->require_shape(query);
  const SignatureQuery prepared(query);
  BestMatches best(count, admits);
  for (const SignatureTree& tree : forest_->trees) tree.search(prepared, best);
  for (std::size_t i = 0; i < forest_->newcomers.size(); ++i) {
    best.offer(prepared, forest_->newcomers, i);
  }
  return best.matches();
}

std::vector<SignatureMatch> SignatureIndex::nearest_by_brute_force(const Signature& query,
                                                                   std::size_t count,
                                                                   const Admission& admits) const {
  forest_->require_shape(query);
  const SignatureQuery prepared(query);
  BestMatches best(count, admits);
  forest_->for_each(
      [&](const SignatureBlock& block, std::size_t i) { best.compare(prepared, block, i); });
  return best.matches();
}

void SignatureIndex::save(const std::string& path) const {
  SignatureBlock all = forest_->empty_block();
  forest_->for_each([&](const SignatureBlock& block, std::size_t i) { all.add(block, i); });
  write_signature_file(path, all);
}

SignatureIndex SignatureIndex::load(const std::string& path) {
  const SignatureBlock all = read_signature_file(path);
  SignatureIndex index(all.rows, all.columns);
  index.forest_->newcomers = all;
  index.forest_->grow();
  if (index.size() != all.size()) throw std::runtime_error(path + ": an id stands in it twice");
  return index;
}

}  // namespace falko_slam
