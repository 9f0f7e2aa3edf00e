#include "run/study/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace shmoo::run::study {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> all;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const auto from = cell.find_first_not_of(" \t\r"), to = cell.find_last_not_of(" \t\r");
    all.push_back(from == std::string::npos ? "" : cell.substr(from, to - from + 1));
  }
  return all;
}

[[noreturn]] void fail(const std::string& file, int line, const std::string& message) {
  throw base::InputError(std::vector<base::Diagnostic>{{{file, line, 0}, message}});
}

double number(const std::string& file, int line, const std::vector<std::string>& row, std::size_t column) {
  double value = 0;
  if (column < row.size()) {
    const auto& text = row[column];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc() && end == text.data() + text.size()) return value;
  }
  fail(file, line, fmt::format("column {} holds no number", column + 1));
}

}  // namespace

std::pair<std::vector<double>, std::vector<double>> read_columns(const std::string& file, const std::string& column) {
  std::ifstream in(file);
  std::pair<std::vector<double>, std::vector<double>> read;
  std::vector<std::string> head;
  std::size_t wanted = 1;
  int number_of_line = 0;
  for (std::string line; std::getline(in, line);) {
    ++number_of_line;
    if (line.empty() || line.front() == '#') continue;
    const auto row = cells(line);
    if (head.empty()) {
      head = row;
      const auto found = std::find(head.begin(), head.end(), column);
      if (!column.empty() && found == head.end())
        fail(file, number_of_line,
             fmt::format("there is no column '{}'{}; it has: {}", column, base::did_you_mean(column, head),
                         base::list_of(head)));
      if (!column.empty()) wanted = std::size_t(found - head.begin());
      continue;
    }
    read.first.push_back(number(file, number_of_line, row, 0));
    read.second.push_back(number(file, number_of_line, row, wanted));
  }
  if (read.first.size() < 2) fail(file, 0, "a reference needs a line of names and at least two lines of numbers");
  if (!std::is_sorted(read.first.begin(), read.first.end())) fail(file, 0, "its first column must ascend");
  return read;
}

}  // namespace shmoo::run::study
