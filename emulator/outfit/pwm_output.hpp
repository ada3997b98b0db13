// An output whose pulse is looked at: of a header of the board, or of an expander.
#pragma once

#include <cstdint>
#include <string>

#include "emulator/outfit/outfit.hpp"

namespace finemote::emulator {

class OutputElement : public Element {
 public:
  OutputElement(Outfit& outfit, const Json& part, const std::string& name);

  [[nodiscard]] double pulse_us() const { return static_cast<double>(pulse_) / 1000; }
  /// The first pulse after the output was off.
  [[nodiscard]] double resumed_with_us() const { return static_cast<double>(resumed_with_) / 1000; }
  /// Values of its row, and of those of classes derived from it.
  static std::vector<scenario::Quantity> values();

 protected:
  virtual void changed() {}
  [[nodiscard]] std::uint64_t pulse_ns() const { return pulse_; }

 private:
  std::uint64_t pulse_ = 0, resumed_with_ = 0;
};

}  // namespace finemote::emulator
