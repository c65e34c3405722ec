/// \file
/// \brief A copy of an object whose class the caller need not know.
#pragma once

#include <memory>
#include <utility>

namespace tumble {

/// Writes clone() for a class.
/// \tparam Base  declares clone(), or passes it on
/// \tparam Own   the class itself, which its copy constructor copies with all memory
template <class Base, class Own>
class Cloned : public Base {
 public:
  using Base::Base;

  /// \return a copy with all memory
  [[nodiscard]] decltype(std::declval<const Base&>().clone()) clone() const override {
    return std::make_unique<Own>(static_cast<const Own&>(*this));
  }
};

}  // namespace tumble
