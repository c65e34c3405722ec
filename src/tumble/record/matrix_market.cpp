/// \file
/// \brief Reading and writing Matrix Market files.
#include "tumble/record/matrix_market.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/suggestion.hpp"
#include "tumble/base/text_file.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

namespace tumble {
namespace {

using Fields = std::vector<std::string>;

std::string joined(const Fields& words) {
  std::string out;
  for (const std::string& word : words) out.append(out.empty() ? "" : " ").append(word);
  return out;
}

Fields words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  Fields words;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

// The text line by line, and where in it we are.
class Lines {
 public:
  Lines(std::string_view text, std::string_view file) : rest_(text), file_(file) {
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);  // marks UTF-8
  }

  // The words of the next line, whatever it is; none at the end.
  Fields next() {
    if (rest_.empty()) return {};
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    Fields words = words_of(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return words;
  }

  // The words of the next line with something to read; none at the end.
  Fields next_entry() {
    while (!rest_.empty()) {
      Fields words = next();
      if (!words.empty() && words.front().front() != '%') return words;
    }
    return {};
  }

  [[noreturn]] void refuse(const Fields& words, const std::string& wanted) const {
    const std::string found = words.empty() ? "the file ends here" : one_line(joined(words));
    throw std::invalid_argument(std::string(file_) + ":" + std::to_string(std::max(line_, 1)) +
                                ": " + found + ": " + wanted);
  }

 private:
  std::string_view rest_;
  std::string_view file_;
  int line_ = 0;
};

struct Header {
  bool coordinate = false;
  bool integer = false;
  bool symmetric = false;
};

Header read_header(Lines& lines) {
  const Fields given = lines.next();
  Fields words = given;
  for (std::string& word : words)
    for (char& c : word)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (words.size() != 5 || words[0] != "%%matrixmarket" || words[1] != "matrix")
    lines.refuse(given,
                 "expected the first line of a Matrix Market file, for example %%MatrixMarket "
                 "matrix array real general");
  if (words[2] != "array" && words[2] != "coordinate")
    lines.refuse(given, "expected array or coordinate for " + one_line(words[2]));
  if (words[3] != "real" && words[3] != "double" && words[3] != "integer")
    lines.refuse(given, "expected real or integer for " + one_line(words[3]));
  if (words[4] != "general" && words[4] != "symmetric")
    lines.refuse(given, "expected general or symmetric for " + one_line(words[4]));
  return {words[2] == "coordinate", words[3] == "integer", words[4] == "symmetric"};
}

bool is_whole(const std::string& word, std::int64_t& value) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const char* begin = word.data() + (plus ? 1 : 0);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end;
}

double value_of(const Fields& words, const Header& header, const Lines& lines) {
  const std::string& word = words.back();
  if (header.integer) {
    constexpr std::int64_t most = std::int64_t{1} << 53U;  // above, doubles have gaps
    std::int64_t value = 0;
    if (!is_whole(word, value) || value < -most || value > most)
      lines.refuse(words, "expected a whole number of at most 2^53");
    return static_cast<double>(value);
  }
  const std::optional<double> value = parse_number(word);
  if (!value) lines.refuse(words, "expected a finite number");
  return *value;
}

// A whole number of a line that has to be in a range.
int index_of(const Fields& words, std::size_t place, int least, int most, const std::string& wanted,
             const Lines& lines) {
  std::int64_t value = 0;
  if (!is_whole(words[place], value) || value < least || value > most) lines.refuse(words, wanted);
  return static_cast<int>(value);
}

MatX read_array(const Header& header, int rows, int columns, Lines& lines) {
  MatX matrix = MatX::Zero(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int i = header.symmetric ? j : 0; i < rows; ++i) {
      const Fields words = lines.next_entry();
      if (words.size() != 1)
        lines.refuse(words, "expected one number, row " + std::to_string(i + 1) + " of column " +
                                std::to_string(j + 1));
      matrix(i, j) = value_of(words, header, lines);
      if (header.symmetric) matrix(j, i) = matrix(i, j);
    }
  }
  return matrix;
}

MatX read_coordinates(const Header& header, int rows, int columns, int count, Lines& lines) {
  MatX matrix = MatX::Zero(rows, columns);
  std::vector<bool> given(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  for (int k = 0; k < count; ++k) {
    const Fields words = lines.next_entry();
    if (words.size() != 3)
      lines.refuse(words, "expected row, column and value, entry " + std::to_string(k + 1) +
                              " of " + std::to_string(count));
    const int i =
        index_of(words, 0, 1, rows, "expected a row from 1 to " + std::to_string(rows), lines) - 1;
    const int j = index_of(words, 1, 1, columns,
                           "expected a column from 1 to " + std::to_string(columns), lines) -
                  1;
    if (header.symmetric && j > i)
      lines.refuse(words, "above the diagonal; of a symmetric matrix give entries on and below it");
    const std::size_t place =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(i);
    if (given[place]) lines.refuse(words, "this entry was given before; give it once");
    given[place] = true;
    matrix(i, j) = value_of(words, header, lines);
    if (header.symmetric) matrix(j, i) = matrix(i, j);
  }
  return matrix;
}

}  // namespace

MatX parse_matrix_market(std::string_view text, std::string_view file) {
  Lines lines(text, file);
  const Header header = read_header(lines);
  const Fields sizes = lines.next_entry();
  if (sizes.size() != (header.coordinate ? 3U : 2U))
    lines.refuse(sizes, header.coordinate ? "expected how many rows, columns and entries there are"
                                          : "expected how many rows and columns there are");
  const std::string range = "expected sizes from 0 to " + std::to_string(kMostMatrixRows);
  const int rows = index_of(sizes, 0, 0, kMostMatrixRows, range, lines);
  const int columns = index_of(sizes, 1, 0, kMostMatrixRows, range, lines);
  if (header.symmetric && rows != columns)
    lines.refuse(sizes, "expected as many rows as columns, because the matrix is symmetric");
  MatX matrix;
  if (header.coordinate) {
    const int most = header.symmetric ? rows * (rows + 1) / 2 : rows * columns;
    const int count =
        index_of(sizes, 2, 0, most, "expected at most " + std::to_string(most) + " entries", lines);
    matrix = read_coordinates(header, rows, columns, count, lines);
  } else {
    matrix = read_array(header, rows, columns, lines);
  }
  const Fields more = lines.next_entry();
  if (!more.empty()) lines.refuse(more, "expected the end, all entries have been given");
  return matrix;
}

MatX read_matrix_market(const std::filesystem::path& path) {
  constexpr std::size_t most_mib = 256;
  return parse_matrix_market(read_text(path, "a Matrix Market file, *.mtx,", most_mib),
                             path.string());
}

std::string to_matrix_market(const MatRef& matrix, std::string_view comment) {
  require::that(comment.find_first_of("\r\n") == std::string_view::npos, "comment: give one line");
  std::string out = "%%MatrixMarket matrix array real general\n";
  if (!comment.empty()) out.append("% ").append(comment).append("\n");
  out.append(std::to_string(matrix.rows())).append(" ");
  out.append(std::to_string(matrix.cols())).append("\n");
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      require::finite(matrix(i, j), "matrix");
      out.append(shortest_text(matrix(i, j))).append("\n");
    }
  }
  return out;
}

}  // namespace tumble
