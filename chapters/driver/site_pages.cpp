/// \file
/// \brief The program that writes those pages of the site that are made from numbers.
#include "driver/appendix_a.hpp"
#include "driver/csv.hpp"
#include "driver/findings.hpp"
#include "driver/pages.hpp"
#include "driver/thesis_map.hpp"

#include <cstdio>
#include <exception>

// Writes `counts.md`, `thesis_map.md`, `ledger.md`, `errata.md`, `tolerances.md`, `gallery.md`,
// `left_open.md` and `appendix_a.md`.
int main(int argc, char** argv) {
  using namespace tumble::chapters;
  if (argc < 5) {
    std::fprintf(
        stderr,
        "usage: site_pages OUT FIGURES src/tumble chapters FILE...\n"
        "FILE: expected.csv, claims.toml, errata.toml, choices.toml, NAME.md, open_claims.toml\n");
    return 2;
  }
  try {
    const std::filesystem::path out = argv[1];
    const std::filesystem::path library = argv[3];
    const std::filesystem::path chapters = argv[4];
    const Findings findings = read_findings(argv[2], {argv + 5, argv + argc});
    const std::vector<Tolerance> tolerances = read_all_tolerances(library);
    const std::vector<AppendixListing> appendix =
        read_appendix(chapters / "appendix_a.toml", sources_in(library));
    const std::vector<ThesisSection> map = read_thesis_map(chapters / "thesis_map.toml");
    write_file(out / "counts.md", counts_text(findings));
    write_file(out / "thesis_map.md", thesis_map_page(map, findings));
    write_file(out / "ledger.md", ledger_page(findings));
    write_file(out / "errata.md", errata_page(findings));
    write_file(out / "tolerances.md", tolerances_page(tolerances));
    write_file(out / "gallery.md", gallery_page(findings));
    for (const std::string& chapter : figure_chapters(findings))
      write_file(out / "figures" / (chapter + ".md"), figures_page(findings, chapter));
    write_file(out / "left_open.md", left_open_page(findings, tolerances));
    write_file(out / "appendix_a.md", appendix_page(appendix, findings.errata));
    return 0;
  } catch (const FileError& error) {
    std::fprintf(stderr, "site_pages: %s\n", error.what());
    return 4;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "site_pages: %s\n", error.what());
    return 2;
  }
}
