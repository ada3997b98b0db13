// The instructions of one function, data between them left out.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/image/image.hpp"
#include "generator/image/instruction.hpp"

namespace finemote::gen {

class FunctionBody {
 public:
  /// `function` is a function symbol of the image, Thumb-2 code. Mapping symbols (AAELF32 5.5.5) tell code from data.
  /// `size` 0: up to the next function.
  FunctionBody(const Image& image, const ImageSymbol& function);

  [[nodiscard]] std::uint32_t begin() const { return begin_; }
  [[nodiscard]] std::uint32_t end() const { return end_; }
  [[nodiscard]] bool contains(std::uint32_t address) const { return address >= begin_ && address < end_; }
  /// By address.
  [[nodiscard]] const std::vector<Instruction>& instructions() const { return instructions_; }
  /// The one that begins there, or null: there are data, or the middle of an instruction.
  [[nodiscard]] const Instruction* at(std::uint32_t address) const;
  /// The one that ends there, or null.
  [[nodiscard]] const Instruction* before(std::uint32_t address) const;

 private:
  std::uint32_t begin_, end_;
  std::vector<Instruction> instructions_;
};

}  // namespace finemote::gen
