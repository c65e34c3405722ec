/// \file
/// \brief The table of a Markov chain, written and read back.
#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"
#include "tumble/base/text_file.hpp"
#include "tumble/record/sampling.hpp"
#include "tumble/record/table_file.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace tumble {
namespace {

constexpr std::string_view kChainHeader =
    "proposal,move,first_id,second_id,impact,accepted,violation,impacts";
constexpr std::size_t kMostMib = 256;

std::optional<std::uint32_t> whole_of(const std::string& cell) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size()) return std::nullopt;
  return value;
}

std::optional<NoiseMove> move_of(const std::string& cell) {
  for (const NoiseMove move : {NoiseMove::all, NoiseMove::redraw, NoiseMove::nudge})
    if (cell == name_of(move)) return move;
  return std::nullopt;
}

std::optional<NoiseProposal> proposal_of(const std::vector<std::string>& cells,
                                         std::size_t number) {
  constexpr std::size_t columns = 8;
  if (cells.size() != columns || whole_of(cells[0]) != number) return std::nullopt;
  const auto move = move_of(cells[1]);
  const auto first = whole_of(cells[2]);
  const auto second = whole_of(cells[3]);
  const auto impact = whole_of(cells[4]);
  const auto accepted = whole_of(cells[5]);
  const auto violation =
      cells[6] == "inf" ? std::numeric_limits<double>::infinity() : parse_number(cells[6]);
  const auto impacts = whole_of(cells[7]);
  constexpr std::uint32_t most = std::numeric_limits<int>::max();
  if (!move || !first || !second || !impact || !accepted || !violation || !impacts ||
      *accepted > 1 || *violation < 0.0 || *impact > most || *impacts > most)
    return std::nullopt;
  return NoiseProposal{*move,
                       {BodyId{*first}, BodyId{*second}, static_cast<int>(*impact)},
                       *accepted == 1,
                       *violation,
                       static_cast<int>(*impacts)};
}

}  // namespace

std::string chain_table(std::span<const NoiseProposal> proposals) {
  std::string out(kChainHeader);
  out += '\n';
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    const NoiseProposal& p = proposals[k];
    out.append(std::to_string(k)).append(1, ',').append(name_of(p.move)).append(1, ',');
    out.append(std::to_string(number_of(p.impact.first))).append(1, ',');
    out.append(std::to_string(number_of(p.impact.second))).append(1, ',');
    out.append(std::to_string(p.impact.number)).append(p.accepted ? ",1," : ",0,");
    out.append(shortest_text(p.violation)).append(1, ',');
    out.append(std::to_string(p.impacts)).append(1, '\n');
  }
  return out;
}

std::vector<NoiseProposal> read_chain(const std::filesystem::path& path) {
  const std::string text = read_text(path, "the table of a chain, *.csv", kMostMib);
  std::vector<NoiseProposal> proposals;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size(); ++line_number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    const std::string place = path.string() + ":" + std::to_string(line_number + 1) + ": ";
    if (line_number == 0) {
      require::that(line == kChainHeader, place + "expected " + std::string(kChainHeader));
      continue;
    }
    const auto proposal = proposal_of(cells_of(line), proposals.size());
    require::that(proposal.has_value(), place +
                                            "expected a row as tumble sample writes it, number " +
                                            std::to_string(proposals.size()));
    proposals.push_back(*proposal);
  }
  return proposals;
}

}  // namespace tumble
