/// \file
/// \brief The errata: where the thesis's text fails, and the numbers that show it.
#include "driver/errata.hpp"

#include "driver/ledger.hpp"
#include "driver/records.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const RecordForm kForm{"erratum",
                       {"id", "section", "kind", "printed", "reading", "scene", "figure", "failure",
                        "mended", "test", "command"}};

// A figure drawn with other settings than its defaults measures nothing.
CheckedNumber measured(CheckedNumber number) {
  if (!number.compared) number.value = std::numeric_limits<double>::quiet_NaN();
  return number;
}

}  // namespace

std::vector<Erratum> read_errata(const std::filesystem::path& path) {
  std::vector<Erratum> errata;
  for (Record& record : read_records(path, kForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    if (texts["kind"] != "misprint" && texts["kind"] != "choice")
      throw std::invalid_argument(record.place + "kind '" + texts["kind"] +
                                  "': give misprint or choice");
    errata.push_back({texts["id"], texts["section"], path.parent_path().filename().string(),
                      texts["kind"], texts["printed"], texts["reading"], texts["scene"],
                      texts["figure"], texts["failure"], texts["mended"], texts["test"],
                      texts["command"], record.place});
  }
  return errata;
}

std::vector<ErratumEntry> find_errata(const std::vector<Erratum>& errata,
                                      const std::vector<DrawnFigure>& figures) {
  std::map<std::string, const Erratum*> known;
  std::vector<ErratumEntry> entries;
  for (const Erratum& erratum : errata) {
    const auto [other, is_new] = known.emplace(erratum.id, &erratum);
    if (!is_new)
      throw std::invalid_argument(erratum.place + "this id stands also at " + other->second->place);
    const auto number = [&](const std::string& quantity) {
      return measured(find_number(figures, erratum.figure, quantity, erratum.place));
    };
    entries.push_back({erratum, number(erratum.failure), number(erratum.mended)});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return earlier_in_thesis(a.erratum.section, b.erratum.section);
  });
  return entries;
}

}  // namespace tumble::chapters
