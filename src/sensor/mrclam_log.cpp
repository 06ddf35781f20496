// Copyright (c) falko_slam contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "falko_slam/sensor/mrclam_log.hpp"

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include "falko_slam/common/line_reader.hpp"
#include "falko_slam/common/number_text.hpp"

namespace falko_slam {
namespace {

constexpr double kLatest = 9e9;  // [s]: its nanoseconds still fit into 64 bits

std::string file_in(const std::string& folder, const std::string& name) {
  const std::string plain = (std::filesystem::path(folder) / (name + ".dat")).string();
  return std::filesystem::exists(plain + ".gz") && !std::filesystem::exists(plain) ? plain + ".gz"
                                                                                   : plain;
}

// The numbers of a line; comments and blank lines are passed over.
class NumberTable {
 public:
  NumberTable(const std::string& path, std::size_t columns) : file_(path), columns_(columns) {}

  bool next(std::vector<double>& numbers) {
    std::string line;
    while (file_.next(line)) {
      std::istringstream words(line);
      std::string word;
      if (!(words >> word) || word.front() == '#') continue;
      numbers.clear();
      do {
        const auto number = number_of(word);
        if (!number) file_.fail("\"" + word + "\" is no number");
        numbers.push_back(*number);
      } while (words >> word);
      if (numbers.size() != columns_) {
        file_.fail(std::to_string(numbers.size()) + " numbers, not " + std::to_string(columns_));
      }
      return true;
    }
    return false;
  }

  Time time_of(double seconds) const {
    if (!(std::abs(seconds) < kLatest)) file_.fail("no time");
    return Time(from_seconds(seconds));
  }

  std::uint32_t count_of(double number) const {
    if (!(number >= 0.0 && number <= 1e9) || number != std::floor(number)) {
      file_.fail("no subject or barcode");
    }
    return static_cast<std::uint32_t>(number);
  }

  [[noreturn]] void fail(const std::string& what) const { file_.fail(what); }

 private:
  LineReader file_;
  std::size_t columns_;
};

std::map<std::uint32_t, std::uint32_t> read_barcodes(const std::string& folder) {
  NumberTable table(file_in(folder, "Barcodes"), 2);
  std::map<std::uint32_t, std::uint32_t> subject_of;
  std::vector<double> row;
  while (table.next(row)) subject_of[table.count_of(row[1])] = table.count_of(row[0]);
  return subject_of;
}

std::vector<MrclamLandmark> read_landmarks(const std::string& folder) {
  NumberTable table(file_in(folder, "Landmark_Groundtruth"), 5);
  std::vector<MrclamLandmark> landmarks;
  std::vector<double> row;
  while (table.next(row)) {
    if (row[3] < 0.0 || row[4] < 0.0) table.fail("a negative deviation");
    PointEstimate position{{row[1], row[2]}, Eigen::Matrix2d::Zero()};
    position.covariance.diagonal() << row[3] * row[3], row[4] * row[4];
    landmarks.push_back({table.count_of(row[0]), position});
  }
  return landmarks;
}

void read_measurements(const std::string& folder, const std::string& path, MrclamRun& run) {
  const auto subject_of = read_barcodes(folder);
  NumberTable table(path, 4);
  std::vector<double> row;
  while (table.next(row)) {
    if (!(row[2] > 0.0)) table.fail("a range that is not above zero");
    const auto subject = subject_of.find(table.count_of(row[1]));
    bool known = false;
    for (const MrclamLandmark& landmark : run.landmarks) {
      known = known || (subject != subject_of.end() && landmark.number == subject->second);
    }
    if (known) {
      run.measurements.push_back({table.time_of(row[0]), subject->second, row[2], row[3]});
    } else {
      ++run.other_measurements;
    }
  }
}

}  // namespace

MrclamRun read_mrclam(const std::string& folder, int robot) {
  const std::string name = "Robot" + std::to_string(robot) + "_";
  MrclamRun run;
  run.landmarks = read_landmarks(folder);
  std::vector<double> row;
  NumberTable odometry(file_in(folder, name + "Odometry"), 3);
  while (odometry.next(row)) run.odometry.push_back({odometry.time_of(row[0]), row[1], row[2]});
  NumberTable truth(file_in(folder, name + "Groundtruth"), 4);
  while (truth.next(row)) {
    run.truth.push_back({truth.time_of(row[0]), {row[1], row[2], row[3]}});
  }
  read_measurements(folder, file_in(folder, name + "Measurement"), run);
  return run;
}

}  // namespace falko_slam
