// Which instructions of a function can follow which.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace finemote::gen {

struct Successor {
  std::uint32_t to = 0;   ///< address of an instruction of the same function
  bool is_taken = false;  ///< by a branch; else the next in sequence
};

/// Of the instructions that are reached; grows while a function is traced.
class Successors {
 public:
  /// True where it is new.
  bool add(std::uint32_t from, Successor successor);

  [[nodiscard]] const std::vector<Successor>& of(std::uint32_t address) const;
  /// The only instruction from which this one is reached, and how; null: there are several, or it is an entry.
  struct Origin {
    std::uint32_t from = 0;
    bool is_taken = false;
  };
  [[nodiscard]] const Origin* only_origin(std::uint32_t address) const;

 private:
  std::map<std::uint32_t, std::vector<Successor>> successors_;
  std::map<std::uint32_t, std::vector<Origin>> origins_;
};

}  // namespace finemote::gen
