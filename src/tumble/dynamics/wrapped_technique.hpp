/// \file
/// \brief Common parts of techniques that wrap another one.
#pragma once

#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

/// A technique that changes when another one steps, or which bodies count as slow in it: all else it leaves to that one.
class WrappedTechnique : public Technique {
 public:
  ~WrappedTechnique() override = default;

  /// What users call it is the technique that is wrapped.
  /// \return for example "basic"
  [[nodiscard]] std::string_view name() const override { return inner_->name(); }
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return inner_->contacts();
  }
  [[nodiscard]] std::vector<Diagnostic> diagnostics() const override {
    return inner_->diagnostics();
  }
  [[nodiscard]] bool holds_joints() const override { return inner_->holds_joints(); }
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

  /// The technique that steps, with the wrapper's observer and slow bodies.
  /// \return the technique
  [[nodiscard]] Technique& inner() {
    inner_->observe(observer());
    inner_->count_as_slow(slow_bodies());
    return *inner_;
  }

 private:
  std::unique_ptr<Technique> inner_;
};

}  // namespace tumble
