/// \file
/// \brief Reading and writing Matrix Market files.
#include "tumble/record/matrix_market.hpp"

#include "tumble/record/table_file.hpp"

#include "support/files.hpp"
#include "support/test.hpp"

#include <filesystem>

namespace {

using Catch::Matchers::StartsWith;

const std::string kArray = "%%MatrixMarket matrix array real general\n";
const std::string kSparse = "%%MatrixMarket matrix coordinate real general\n";

MatX parse(const std::string& text) { return parse_matrix_market(text, "x.mtx"); }

MatX rows(std::initializer_list<std::initializer_list<double>> values) { return MatX(values); }

}  // namespace

TEST_CASE("All eight forms of the same Matrix Market file give the same matrix",
          "[unit][matrix_market]") {
  const MatX expected = rows({{2, -1, 0}, {-1, 2, 5}, {0, 5, 3}});
  const std::string all = "3 3\n2\n-1\n0\n-1\n2\n5\n0\n5\n3\n";
  const std::string lower = "3 3\n2\n-1\n0\n2\n5\n3\n";
  const std::string entries = "3 3 7\n3 3 3\n1 1 2\n2 1 -1\n1 2 -1\n2 2 2\n3 2 5\n2 3 5\n";
  const std::string lower_entries = "3 3 5\n1 1 2\n2 1 -1\n2 2 2\n3 2 5\n3 3 3\n";
  for (const std::string numbers : {"real", "integer"}) {
    const std::string array = "%%MatrixMarket matrix array " + numbers;
    const std::string sparse = "%%MatrixMarket matrix coordinate " + numbers;
    CHECK(parse(array + " general\n" + all) == expected);
    CHECK(parse(array + " symmetric\n" + lower) == expected);
    CHECK(parse(sparse + " general\n" + entries) == expected);
    CHECK(parse(sparse + " symmetric\n" + lower_entries) == expected);
  }
}

TEST_CASE("Capitals, comments, empty lines, other line ends and a missing last one do no harm",
          "[unit][matrix_market]") {
  const std::string text =
      "%%matrixmarket MATRIX Array Double General\r\n% so\r\n%\r\n\r\n 2\t2 \r\n+1e0\r\n % so\r\n"
      "-2.5E-1\r\n\r\n.5\r\n4.";
  CHECK(parse(text) == rows({{1, 0.5}, {-0.25, 4}}));
  CHECK(parse("\xEF\xBB\xBF" + text) == rows({{1, 0.5}, {-0.25, 4}}));  // a mark of UTF-8
  CHECK(parse("%%MatrixMarket matrix array integer general\n2 1\n+7\n-9007199254740992") ==
        rows({{7}, {-9007199254740992.0}}));
}

TEST_CASE("Columns, rows and matrices without entries are matrices too", "[unit][matrix_market]") {
  CHECK(parse(kArray + "2 1\n1\n2\n") == rows({{1}, {2}}));
  CHECK(parse(kArray + "1 2\n1\n2\n") == rows({{1, 2}}));
  CHECK(parse(kArray + "0 0\n").size() == 0);
  CHECK(parse(kArray + "0 1\n").cols() == 1);
  CHECK(parse(kSparse + "2 2 0\n") == MatX::Zero(2, 2));
}

TEST_CASE("A matrix that is written reads back to the same bits", "[unit][matrix_market]") {
  Random random(3);
  for (int count = 0; count < 100; ++count) {
    const int m = static_cast<int>(random.below(6));
    const int n = static_cast<int>(random.below(6));
    MatX matrix(m, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < m; ++i) {
        const int exponent = static_cast<int>(random.below(2000)) - 1050;  // denormal ones too
        matrix(i, j) = std::ldexp(random.uniform(-1.0, 1.0), exponent);
      }
    const MatX back = parse(to_matrix_market(matrix, "of chance"));
    REQUIRE(back.rows() == m);
    REQUIRE(back.cols() == n);
    CHECK(back == matrix);
  }
  CHECK(to_matrix_market(rows({{0.1, -0.0}}), "small") == kArray + "% small\n1 2\n0.1\n-0\n");
}

TEST_CASE("What cannot be written as a Matrix Market file is refused", "[unit][matrix_market]") {
  CHECK_THROWS_WITH(to_matrix_market(rows({{1, kNan}})), Contains("matrix = nan"));
  CHECK_THROWS_AS(to_matrix_market(rows({{kInfinity}})), std::invalid_argument);
  CHECK_THROWS_WITH(to_matrix_market(rows({{1}}), "a\nb"), Contains("comment"));
}

TEST_CASE("A mistake in a Matrix Market file is reported with its line and the expected form",
          "[unit][matrix_market]") {
  struct Case {
    std::string text, message;
  };
  const std::string whole = "%%MatrixMarket matrix array integer general\n";
  const std::string lower = "%%MatrixMarket matrix coordinate real symmetric\n";
  const std::vector<Case> cases{
      {"", "x.mtx:1: the file ends here: expected the first line of a Matrix Market file"},
      {"2 2\n1\n", "x.mtx:1: 2 2: expected the first line"},
      {"\n" + kArray, "x.mtx:1: the file ends here: expected the first line"},
      {"%%MatrixMarket matrix array real\n1 1\n1\n", "x.mtx:1: %%MatrixMarket matrix array real: "},
      {"%%MatrixMarket matrix list real general\n", "expected array or coordinate for list"},
      {"%%MatrixMarket matrix array complex general\n", "expected real or integer for complex"},
      {"%%MatrixMarket matrix coordinate pattern general\n", "real or integer for pattern"},
      {"%%MatrixMarket matrix array real skew-symmetric\n", "general or symmetric for skew"},
      {kArray, "x.mtx:1: the file ends here: expected how many rows and columns there are"},
      {kArray + "% no\n2 2 4\n", "x.mtx:3: 2 2 4: expected how many rows and columns there are"},
      {kSparse + "2 2\n", "x.mtx:2: 2 2: expected how many rows, columns and entries there are"},
      {kArray + "2 -2\n", "x.mtx:2: 2 -2: expected sizes from 0 to 5000"},
      {kArray + "2 1e3\n", "x.mtx:2: 2 1e3: expected sizes from 0 to 5000"},
      {kArray + "5001 1\n", "expected sizes from 0 to 5000"},
      {kArray + "99999999999999999999 1\n", "expected sizes from 0 to 5000"},
      {lower + "2 3 1\n", "x.mtx:2: 2 3 1: expected as many rows as columns"},
      {kArray + "2 1\n1\n", "x.mtx:3: the file ends here: expected one number, row 2 of column 1"},
      {kArray + "2 1\n1 2\n", "x.mtx:3: 1 2: expected one number, row 1 of column 1"},
      {kArray + "1 1\none\n", "x.mtx:3: one: expected a finite number"},
      {kArray + "1 1\n1.0D0\n", "x.mtx:3: 1.0D0: expected a finite number"},
      {kArray + "1 1\nnan\n", "x.mtx:3: nan: expected a finite number"},
      {kArray + "1 1\n-inf\n", "expected a finite number"},
      {kArray + "1 1\n1e999\n", "x.mtx:3: 1e999: expected a finite number"},
      {kArray + "1 1\n1\n\n2\n", "x.mtx:5: 2: expected the end"},
      {whole + "1 1\n1.5\n", "x.mtx:3: 1.5: expected a whole number of at most 2^53"},
      {whole + "1 1\n+-5\n", "x.mtx:3: +-5: expected a whole number"},
      {whole + "1 1\n+\n", "x.mtx:3: +: expected a whole number"},
      {whole + "1 1\n9007199254740993\n", "expected a whole number of at most 2^53"},
      {kSparse + "2 2 5\n", "x.mtx:2: 2 2 5: expected at most 4 entries"},
      {lower + "2 2 4\n", "x.mtx:2: 2 2 4: expected at most 3 entries"},
      {kSparse + "2 2 1\n0 1 1\n", "x.mtx:3: 0 1 1: expected a row from 1 to 2"},
      {kSparse + "2 2 1\n1 3 1\n", "x.mtx:3: 1 3 1: expected a column from 1 to 2"},
      {kSparse + "2 2 1\n1 1\n", "x.mtx:3: 1 1: expected row, column and value, entry 1 of 1"},
      {kSparse + "2 2 2\n1 1 1\n", "x.mtx:3: the file ends here: expected row, column and value"},
      {kSparse + "2 2 2\n1 1 1\n1 1 2\n", "x.mtx:4: 1 1 2: this entry was given before"},
      {lower + "2 2 1\n1 2 1\n", "x.mtx:3: 1 2 1: above the diagonal"},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    CHECK_THROWS_WITH(parse(c.text), StartsWith("x.mtx:") && Contains(c.message));
  }
  CHECK_THROWS_WITH(parse(kArray + "1 1\n" + std::string(5000, '\x7f') + "\n"),
                    Contains("...: expected a finite number"));
}

TEST_CASE("A Matrix Market file that is no file is distinguished", "[unit][matrix_market]") {
  const test::Folder folder("matrix_market");
  const std::filesystem::path file = folder.file("one.mtx");
  CHECK_THROWS_WITH(read_matrix_market(file), Contains("there is no such file"));
  CHECK_THROWS_WITH(read_matrix_market(folder.path), Contains("is a folder"));
  write_file(file, to_matrix_market(rows({{1, 2}, {3, 4}})));
  CHECK(read_matrix_market(file) == rows({{1, 2}, {3, 4}}));
}
