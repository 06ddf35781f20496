// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/slam/slam_state_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "falko_slam/common/bytes.hpp"
#include "falko_slam/common/whole_file.hpp"
#include "support/slam_states.hpp"
#include "support/temporary_folder.hpp"

namespace falko_slam {
namespace {

class SlamStateFile : public ::testing::Test {
 protected:
  // Writes bytes that are no good and returns what loading them says.
  std::string error_of(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
    try {
      load_slam_state(path_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  void expect_named(const std::string& bytes, std::size_t where) const {
    EXPECT_EQ(error_of(bytes).find(path_ + ": "), 0U) << where << ": " << error_of(bytes);
  }
  static std::string sealed(std::string bytes) {
    bytes.resize(bytes.size() - 4);
    ByteWriter out;
    out.text(bytes);
    out.u32(checksum(bytes, bytes.size()));
    return std::move(out).bytes();
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("state.map");
  SlamState state_ = test::office_state(2.0);
};

TEST_F(SlamStateFile, ComesBackAsItWasSaved) {
  save_slam_state(path_, state_);
  const SlamState loaded = load_slam_state(path_);
  ASSERT_EQ(loaded.keyframes.size(), state_.keyframes.size());
  ASSERT_EQ(loaded.graph.nodes.size(), state_.graph.nodes.size());
  for (std::size_t i = 0; i < loaded.graph.nodes.size(); ++i) {
    const Pose2& pose = loaded.graph.nodes[i].map_T_node;
    EXPECT_EQ(pose.translation(), state_.graph.nodes[i].map_T_node.translation());
    EXPECT_EQ(pose.theta(), state_.graph.nodes[i].map_T_node.theta());
    EXPECT_EQ(loaded.keyframes[i].stamp, state_.keyframes[i].stamp);
    EXPECT_EQ(loaded.keyframes[i].drive, state_.keyframes[i].drive);
  }
  ASSERT_EQ(loaded.graph.constraints.size(), state_.graph.constraints.size());
  for (std::size_t i = 0; i < loaded.graph.constraints.size(); ++i) {
    const GraphConstraint &a = loaded.graph.constraints[i], &b = state_.graph.constraints[i];
    EXPECT_EQ(a.from, b.from);
    EXPECT_EQ(a.to, b.to);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.from_T_to.translation(), b.from_T_to.translation());
    EXPECT_TRUE(a.information.isApprox(b.information, 1e-12));
  }
  EXPECT_EQ(loaded.graph.fixed.size(), state_.graph.fixed.size());
  EXPECT_EQ(to_bytes(loaded), to_bytes(slam_state_from(to_bytes(loaded))));
}

TEST_F(SlamStateFile, EveryTruncationIsAnErrorThatNamesTheFile) {
  const std::string whole = to_bytes(state_);
  for (std::size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 7) {
    expect_named(whole.substr(0, size), size);
  }
  expect_named(whole.substr(0, whole.size() - 1), whole.size() - 1);
  expect_named(whole + '\0', whole.size() + 1);
}

// Also where the checksum fits, so that all that is behind it is looked at.
TEST_F(SlamStateFile, EveryTruncationThatIsSealedIsAnErrorToo) {
  const std::string whole = to_bytes(state_);
  for (std::size_t size = 12; size < whole.size() - 4; size += 5) {
    expect_named(sealed(whole.substr(0, size) + "1234"), size);
  }
}

TEST_F(SlamStateFile, AFlippedBitIsAnErrorThatNamesTheFile) {
  auto random = test::seeded_random();
  const std::string whole = to_bytes(state_);
  for (int i = 0; i < 500; ++i) {
    std::string damaged = whole;
    const auto at = static_cast<std::size_t>(
        test::uniform(random, 0.0, static_cast<double>(whole.size()) - 1e-6));
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (i % 8)));
    expect_named(damaged, at);
  }
}

// No crash, no endless allocation: a state that makes sense, or an error.
TEST_F(SlamStateFile, AFlippedBitThatIsSealedDoesNoHarm) {
  auto random = test::seeded_random();
  const std::string whole = to_bytes(state_);
  for (int i = 0; i < 500; ++i) {
    std::string damaged = whole;
    const double half = i % 2 == 0 ? 1.0 : 0.02;  // often where the counts are
    const auto at = static_cast<std::size_t>(
        test::uniform(random, 0.0, half * static_cast<double>(whole.size()) - 4.0));
    damaged[i % 4 == 0 ? whole.size() - 5 - at % 3000 : at] ^= static_cast<char>(1 << (i % 8));
    try {
      const SlamState state = slam_state_from(sealed(damaged));
      EXPECT_EQ(state.keyframes.size(), state.graph.nodes.size());
      FeatureSlam(SlamParams(), state);
    } catch (const std::runtime_error&) {
    }
  }
}

TEST_F(SlamStateFile, SavesNoStateWithoutKeyframesAndOverNothingElse) {
  EXPECT_THROW(save_slam_state(path_, SlamState()), std::runtime_error);
  EXPECT_TRUE(folder_.names().empty());
  const std::string notes = folder_.write("notes.txt", "mine");
  EXPECT_THROW(save_slam_state(notes, state_), std::runtime_error);
  EXPECT_EQ(read_whole_file(notes), "mine");
  EXPECT_THROW(save_slam_state(folder_.file("no/state.map"), state_), std::runtime_error);
}

}  // namespace
}  // namespace falko_slam
