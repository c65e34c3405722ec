/// \file
/// \brief Common parts of techniques that wrap another one.
#pragma once

#include "tumble/base/error.hpp"
#include "tumble/dynamics/technique.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble {

/// Base of techniques that change the steps of another one and forward everything else to it, for example AdaptiveStep.
class WrappedTechnique : public Technique {
 public:
  ~WrappedTechnique() override = default;

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
  /// Wraps a technique.
  /// \throws std::invalid_argument if it is null
  explicit WrappedTechnique(std::unique_ptr<Technique> inner) : inner_(std::move(inner)) {
    require::that(inner_ != nullptr, "a technique that goes around another one got none");
  }
  /// For clone(): the technique inside is cloned.
  WrappedTechnique(const WrappedTechnique& other)
      : Technique(other), inner_(other.inner_->clone()) {}
  WrappedTechnique& operator=(const WrappedTechnique&) = delete;

  /// The wrapped technique, once it has been given the wrapper's observer and slow bodies: ready to step.
  [[nodiscard]] Technique& prepared_inner() {
    inner_->observe(observer());
    inner_->count_as_slow(slow_bodies());
    return *inner_;
  }

 private:
  std::unique_ptr<Technique> inner_;
};

}  // namespace tumble
