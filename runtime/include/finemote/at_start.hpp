// A word that is set while the robot starts and never again.
#pragma once

namespace finemote {

/// Tools read the value it gets during start-up out of the image and rely on it: code that uses it has the execution
/// time it has with this value. Set it before the first release only.
template <class T>
class AtStart {
 public:
  constexpr AtStart() = default;
  constexpr explicit AtStart(T value) : value_(value) {}

  constexpr operator T() const { return value_; }    ///< its value
  constexpr T operator->() const { return value_; }  ///< of a pointer: what it points to
  void set(T value) { value_ = value; }              ///< Context: init.

 private:
  T value_{};
};

}  // namespace finemote
