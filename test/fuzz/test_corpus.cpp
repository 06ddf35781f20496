// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Replays the seeds of the fuzz targets, and every input that was once a finding.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "falko_slam/common/whole_file.hpp"
#include "fuzz/fuzz_targets.hpp"

namespace falko_slam {
namespace {

struct NamedTarget {
  const char* name;
  void (*run)(const std::string& input);
};
#define FALKO_SLAM_NAMED(NAME) {#NAME, fuzz::fuzz_##NAME},
const std::vector<NamedTarget> kTargets{FALKO_SLAM_FUZZ_TARGETS(FALKO_SLAM_NAMED)};
#undef FALKO_SLAM_NAMED

std::vector<std::string> corpus_of(const std::string& target) {
  std::vector<std::string> paths;
  for (const auto& entry :
       std::filesystem::directory_iterator(FALKO_SLAM_SOURCE_DIR "/test/fuzz/corpus/" + target)) {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

class FuzzTarget : public ::testing::TestWithParam<NamedTarget> {};

TEST_P(FuzzTarget, TakesItsCorpus) {
  const std::vector<std::string> corpus = corpus_of(GetParam().name);

  for (const std::string& path : corpus) {
    SCOPED_TRACE(path);
    GetParam().run(read_whole_file(path));
  }

  EXPECT_FALSE(corpus.empty());
}

TEST_P(FuzzTarget, TakesNothing) { GetParam().run(""); }

INSTANTIATE_TEST_SUITE_P(All, FuzzTarget, ::testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace falko_slam
