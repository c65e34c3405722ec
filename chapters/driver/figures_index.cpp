/// \file
/// \brief The program that checks the numbers of all figures and writes the page that shows them.
#include "driver/csv.hpp"
#include "driver/findings.hpp"
#include "driver/pages.hpp"
#include "driver/reads.hpp"

#include <cstdio>
#include <exception>

// Checks `DIR/*_numbers.csv` against the expected values, judges the claims and writes
// `DIR/index.html` and `DIR/claims.csv`.
int main(int argc, char** argv) {
  using namespace tumble::chapters;
  if (argc < 3) {
    std::fprintf(
        stderr,
        "usage: figures_index DIR FILE...\n"
        "FILE: expected.csv, claims.toml, errata.toml, choices.toml, figures.toml, NAME.md, "
        "open_claims.toml, NAME.gif\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    const Findings findings = read_findings(folder, {argv + 2, argv + argc});
    write_file(folder / "claims.csv", ledger_csv(findings.ledger));
    write_file(folder / "index.html", index_page(findings));

    // Every difference is named before the last line sums up.
    const std::vector<std::string> wrong = differences(findings);
    for (const std::string& line : wrong) std::fprintf(stderr, "%s\n", line.c_str());
    const std::string others = others_text(findings);
    if (!others.empty()) std::printf("%s\n", others.c_str());
    std::printf("%s\n", reads_counts(findings.ledger).c_str());
    std::printf("%s\n", summary_text(findings).c_str());
    return wrong.empty() ? 0 : 3;
  } catch (const FileError& error) {
    std::fprintf(stderr, "figures_index: %s\n", error.what());
    return 4;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figures_index: %s\n", error.what());
    return 2;
  }
}
