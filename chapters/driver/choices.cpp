/// \file
/// \brief Choices that the thesis leaves open: our values, and the numbers with others.
#include "driver/choices.hpp"

#include "tumble/scenes/library.hpp"
#include "tumble/techniques.hpp"

#include "driver/records.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

const RecordForm kChoiceForm{
    "choice", {"id", "section", "what", "why"}, {"value", "from", "unmeasured"}, {}, "varied"};
const RecordForm kVariedForm{"varied",
                             {"id", "choice", "figure", "chosen"},
                             {"half", "double", "other", "change"},
                             {},
                             "choice"};

// The claim that a number decides by a rule.
const LedgerEntry* decided_by(const Variation& variation, const std::vector<LedgerEntry>& ledger) {
  const auto found = std::ranges::find_if(ledger, [&](const LedgerEntry& entry) {
    const Claim& claim = entry.claim;
    return !claim.open && claim.figure == variation.figure && claim.quantity == variation.chosen;
  });
  return found == ledger.end() ? nullptr : &*found;
}

VariedNumber varied_number(const std::string& change, const std::string& quantity,
                           const Variation& variation, const std::vector<DrawnFigure>& figures,
                           const LedgerEntry* decided) {
  VariedNumber varied{.change = change,
                      .number = find_number(figures, variation.figure, quantity, variation.place)};
  if (!varied.number.compared) varied.number.value = std::numeric_limits<double>::quiet_NaN();
  if (std::isnan(varied.number.value)) return varied;
  varied.verdict = Verdict::not_comparable;
  if (decided != nullptr && decided->claim.comparable) {
    const Rule rule = read_rule(decided->claim.confirmed, decided->claim.refuted);
    varied.verdict = rule.verdict(varied.number.value);
  }
  return varied;
}

VariedEntry varied_entry(const Variation& variation, const std::vector<DrawnFigure>& figures,
                         const std::vector<LedgerEntry>& ledger) {
  const LedgerEntry* decided = decided_by(variation, ledger);
  VariedEntry entry{.figure = variation.figure,
                    .claim = decided == nullptr ? "" : decided->claim.id,
                    .chosen = varied_number("", variation.chosen, variation, figures, decided)};
  for (const auto& [change, quantity] : {std::pair{std::string("half"), variation.half},
                                         {std::string("double"), variation.doubled},
                                         {variation.change, variation.other}}) {
    if (quantity.empty()) continue;
    entry.changed.push_back(varied_number(change, quantity, variation, figures, decided));
    const std::string& unit = entry.changed.back().number.unit;
    if (unit != entry.chosen.number.unit)
      throw std::invalid_argument(variation.place + '\'' + quantity + "' is in " + unit + ", '" +
                                  variation.chosen + "' in " + entry.chosen.number.unit);
  }
  return entry;
}

}  // namespace

Choices read_choices(const std::filesystem::path& path) {
  Choices all;
  for (Record& record : read_records(path, kChoiceForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    if (texts["value"].empty() && texts["from"].empty())
      throw std::invalid_argument(record.place + "give a value, or where it is from");
    all.choices.push_back({texts["id"], texts["section"], path.parent_path().filename().string(),
                           texts["what"], texts["value"], texts["from"], texts["why"],
                           texts["unmeasured"], record.place});
  }
  for (Record& record : read_records(path, kVariedForm)) {
    std::map<std::string, std::string>& texts = record.texts;
    if ((texts["half"] + texts["double"] + texts["other"]).empty())
      throw std::invalid_argument(record.place + "give half, double or other");
    if (texts["other"].empty() != texts["change"].empty())
      throw std::invalid_argument(record.place + "other and change belong together");
    all.variations.push_back({texts["choice"], texts["figure"], texts["chosen"], texts["half"],
                              texts["double"], texts["other"], texts["change"], record.place});
  }
  return all;
}

bool VariedEntry::changes_verdict() const {
  if (claim.empty() || chosen.verdict == Verdict::not_measured) return false;
  return std::ranges::any_of(changed, [&](const VariedNumber& one) {
    return one.verdict != Verdict::not_measured && one.verdict != chosen.verdict;
  });
}

std::vector<ChoiceEntry> find_choices(const Choices& all, const std::vector<DrawnFigure>& figures,
                                      const std::vector<LedgerEntry>& ledger) {
  std::map<std::string, std::size_t> known;
  std::vector<ChoiceEntry> entries;
  for (const Choice& choice : all.choices) {
    const auto [other, is_new] = known.emplace(choice.id, entries.size());
    if (!is_new)
      throw std::invalid_argument(choice.place + "this id stands also at " +
                                  entries[other->second].choice.place);
    entries.push_back({choice, {}});
  }
  for (const Variation& variation : all.variations) {
    const auto choice = known.find(variation.choice);
    if (choice == known.end())
      throw std::invalid_argument(variation.place + "there is no choice '" + variation.choice +
                                  '\'');
    entries[choice->second].numbers.push_back(varied_entry(variation, figures, ledger));
  }
  for (const ChoiceEntry& entry : entries) {
    if (entry.numbers.empty() == entry.choice.unmeasured.empty()) {
      throw std::invalid_argument(entry.choice.place +
                                  (entry.numbers.empty()
                                       ? "no [[varied]] names it: say in 'unmeasured' why not"
                                       : "it was varied, so leave 'unmeasured' out"));
    }
  }
  return entries;
}

namespace {

[[noreturn]] void refuse(const Choice& choice, const std::string& what) {
  throw std::invalid_argument(choice.place + "from: " + what);
}

ChosenValue setting(const Choice& choice, const Parameters& parameters, const std::string& owner,
                    const std::string& key) {
  for (const Parameter& one : parameters.all())
    if (one.key == key) return {key, one.value, one.unit, one.meaning};
  refuse(choice, owner + " has no setting '" + key + '\'');
}

ChosenValue constant(const Choice& choice, const std::vector<Tolerance>& constants,
                     const std::string& name) {
  const auto found =
      std::ranges::find_if(constants, [&](const Tolerance& one) { return one.name == name; });
  if (found == constants.end()) refuse(choice, "there is no constant '" + name + '\'');
  return {name, found->value, found->unit, found->meaning};
}

// A figure's parameter, "rows = 5 [-] of the pyramid".
ChosenValue parameter(const Choice& choice, const DrawnFigure& figure, const std::string& key) {
  if (figure.head.empty()) return {key, "", "-", "of the figure " + figure.name};
  for (const std::string& line : figure.parameters) {
    const std::size_t equals = line.find(" = ");
    const std::size_t unit = line.find(" [", equals);
    const std::size_t end = line.find("] ", unit);
    if (end == std::string::npos || line.substr(0, equals) != key) continue;
    return {key, line.substr(equals + 3, unit - equals - 3), line.substr(unit + 2, end - unit - 2),
            line.substr(end + 2)};
  }
  refuse(choice, "figure " + figure.name + " has no parameter '" + key + '\'');
}

// One source, "scene fig6_6: rows speed".
void append_source(const Choice& choice, const ValueSources& sources, const std::string& source,
                   std::vector<ChosenValue>& values) {
  const std::size_t colon = source.find(':');
  if (colon == std::string::npos) refuse(choice, '\'' + source + "' has no ':' before its keys");
  std::istringstream head(source.substr(0, colon));
  std::string kind;
  std::string name;
  head >> kind >> name;
  std::istringstream keys(source.substr(colon + 1));
  for (std::string key; keys >> key;) {
    try {
      if (kind == "scene") {
        values.push_back(setting(choice, scene_recipe(name).parameters(), name, key));
      } else if (kind == "technique") {
        values.push_back(setting(choice, technique_recipe(name).options(), name, key));
      } else if (kind == "constants") {
        values.push_back(constant(choice, sources.constants, key));
      } else if (kind == "figure") {
        const DrawnFigure* figure = figure_of(sources.figures, name);
        if (figure == nullptr) refuse(choice, "there is no figure '" + name + '\'');
        values.push_back(parameter(choice, *figure, key));
      } else {
        refuse(choice, '\'' + kind + "': give scene, technique, constants or figure");
      }
    } catch (const std::invalid_argument& error) {
      const std::string text = error.what();
      if (text.starts_with(choice.place)) throw;
      refuse(choice, text);  // a scene or technique that does not exist
    }
  }
}

}  // namespace

std::vector<ChosenValue> chosen_values(const Choice& choice, const ValueSources& sources) {
  std::vector<ChosenValue> values;
  std::istringstream parts(choice.from);
  for (std::string part; std::getline(parts, part, ';');)
    append_source(choice, sources, part, values);
  if (values.empty() && !choice.from.empty()) refuse(choice, "no keys are named");
  return values;
}

}  // namespace tumble::chapters
