/// \file
/// \brief Texts of others in messages.
#include "tumble/base/one_line.hpp"

namespace tumble {
namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }  // UTF-8

}  // namespace

std::string one_line(std::string_view text) {
  constexpr std::size_t most = 60;
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
