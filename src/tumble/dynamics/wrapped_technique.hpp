/// \file
/// \brief What techniques have in common that go around another one.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A technique that changes when or with which marks another one steps: all else it leaves to that one.
class WrappedTechnique : public Technique {
 public:
  ~WrappedTechnique() override = default;

  /// What users call it is the technique that is wrapped.
  /// \return for example "damped"
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return inner_->contacts();
  }
  [[nodiscard]] const LcpProblem* unsolved_problem() const override {
    return inner_->unsolved_problem();
  }
  [[nodiscard]] std::vector<std::string> ignores(const World& world) const override {
    return inner_->ignores(world);
  }

 protected:
  /// Takes over a technique.
  /// \param inner what steps
  /// \throws std::invalid_argument for no technique
  explicit WrappedTechnique(std::unique_ptr<Technique> inner);
  /// For clone(): the technique inside is cloned.
  /// \param other the original
  WrappedTechnique(const WrappedTechnique& other)
      : Technique(other), inner_(other.inner_->clone()) {}
  WrappedTechnique& operator=(const WrappedTechnique&) = delete;

  /// What steps, watched by whoever watches the wrapper.
  /// \return the technique
  [[nodiscard]] Technique& inner() {
    inner_->observe(observer());
    return *inner_;
  }

 private:
  std::unique_ptr<Technique> inner_;
};

}  // namespace tumble
