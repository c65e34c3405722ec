/// \file
/// \brief The hash in its printed form.
#include "tumble/base/state_hash.hpp"

namespace tumble {

std::string StateHash::text() const {
  constexpr const char* digits = "0123456789abcdef";
  std::string out(16, '0');
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = digits[(value_ >> (60 - 4 * i)) & 0xfU];
  return out;
}

}  // namespace tumble
