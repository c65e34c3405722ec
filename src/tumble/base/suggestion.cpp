/// \file
/// \brief Distance between words, and texts that no terminal takes as a command.
#include "tumble/base/suggestion.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tumble {

namespace {

constexpr std::size_t kLongest = 64;   // letters; what is longer is no name of ours
constexpr std::size_t kBeginning = 4;  // letters of a beginning, at least

// How many insertions, deletions, replacements and swaps of neighbours lead from a to b, and to the beginning of b
// that is closest to a: row i of the table has the distances from the first i letters of a to all beginnings of b.
struct Distances {
  std::size_t whole, beginning;
};

Distances distances(std::string_view a, std::string_view b) {
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.resize(b.size() + 1);
  auto& [before, last, now] = rows;
  for (std::size_t k = 0; k <= b.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t replaced = last[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      now[k] = std::min({last[k] + 1, now[k - 1] + 1, replaced});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        now[k] = std::min(now[k], before[k - 2] + 1);
    }
    before.swap(last);
    last.swap(now);
  }
  return {last[b.size()], *std::min_element(last.begin(), last.end())};
}

}  // namespace

std::string_view closest_name(std::string_view word, std::span<const std::string_view> known) {
  std::string_view best;
  if (word.size() > kLongest) return best;
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::size_t least_begun = word.size() / 4 + 1;
  std::string_view begun;
  for (const std::string_view name : known) {
    const Distances d = distances(word, name);
    if (d.whole < least) {
      least = d.whole;
      best = name;
    }
    if (d.beginning < least_begun && word.size() >= kBeginning) {
      least_begun = d.beginning;
      begun = name;
    }
  }
  return best.empty() ? begun : best;
}

std::string expected_names(std::string_view word, std::span<const std::string_view> known) {
  std::string out;
  const std::string_view close = closest_name(word, known);
  if (!close.empty()) out.append("did you mean ").append(close).append("? Expected one of: ");
  if (close.empty()) out = "expected one of: ";
  for (std::size_t k = 0; k < known.size(); ++k) out.append(k > 0 ? ", " : "").append(known[k]);
  return out;
}

namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }  // UTF-8

}  // namespace

std::string one_line(std::string_view text, std::size_t most) {
  std::string out(text.substr(0, most));
  if (text.size() > most) {
    std::size_t end = most;
    while (end > 0 && continues(text[end])) --end;
    out = out.substr(0, end) + "...";
  }
  for (std::size_t k = 0; k < out.size(); ++k) {
    const auto byte = static_cast<unsigned char>(out[k]);
    // Control characters of ASCII, and those that UTF-8 writes as c2 80 to c2 9f and some terminals take as bytes.
    const bool lead = byte == 0xc2U && k + 1 < out.size() &&
                      static_cast<unsigned char>(out[k + 1]) >= 0x80U &&
                      static_cast<unsigned char>(out[k + 1]) < 0xa0U;
    if (lead) out[k + 1] = ' ';
    const bool alone =
        continues(out[k]) && (k == 0 || (static_cast<unsigned char>(out[k - 1]) < 0x80U));
    if (byte < 0x20U || byte == 0x7fU || lead || alone) out[k] = ' ';
  }
  return out;
}

}  // namespace tumble
