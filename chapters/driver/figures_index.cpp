/// \file
/// \brief The program that checks the numbers of all figures and writes the page that shows them.
#include "driver/check.hpp"
#include "driver/csv.hpp"
#include "driver/index_page.hpp"

#include <cstdio>
#include <exception>

/// Checks `DIR/*_numbers.csv` against the expected values and writes `DIR/index.html`.
/// \param argc  at least 3
/// \param argv  the program, DIR, and the `expected.csv` of each chapter
/// \return exit code: 0 all agree, 2 bad input, 3 a number differs, 4 cannot read or write
int main(int argc, char** argv) {
  using namespace tumble::chapters;
  if (argc < 3) {
    std::fprintf(stderr, "usage: figures_index DIR EXPECTED.csv...\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const auto figures = check_figures(folder, {argv + 2, argv + argc});
    write_file(folder / "index.html", index_page(figures));

    // Every difference is named before the last line sums up.
    int code = 0;
    for (const DrawnFigure& figure : figures) {
      for (const CheckedNumber& number : figure.numbers) {
        if (number.agrees()) continue;
        std::fprintf(stderr, "%s\n", difference_text(figure.name, number).c_str());
        code = 3;
      }
    }
    std::printf("%s\n", summary_text(figures).c_str());
    return code;
  } catch (const FileError& error) {
    std::fprintf(stderr, "figures_index: %s\n", error.what());
    return 4;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figures_index: %s\n", error.what());
    return 2;
  }
}
