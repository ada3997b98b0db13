#include "generator/image/body.hpp"

#include <algorithm>
#include <iterator>

namespace finemote::gen {
namespace {

constexpr std::uint32_t kMostBytesWithoutSize = 4096;

std::uint32_t end_of(const Image& image, const ImageSymbol& function) {
  if (function.size != 0) return function.address + function.size;
  for (const ImageSymbol& symbol : image.symbols) {
    if (symbol.address > function.address && symbol.kind == ImageSymbol::Kind::function) return symbol.address;
  }
  return function.address + kMostBytesWithoutSize;
}

/// `$d`, `$d.1`: data from here on; `$t`: code.
bool begins_data(const ImageSymbol& mapping) { return mapping.name[1] == 'd'; }

}  // namespace

FunctionBody::FunctionBody(const Image& image, const ImageSymbol& function)
    : begin_(function.address), end_(end_of(image, function)) {
  const auto decode_run = [&](std::uint32_t from, std::uint32_t to) {
    std::vector<Instruction> run = decode(from, image.bytes(from, to - from));
    std::move(run.begin(), run.end(), std::back_inserter(instructions_));
  };
  auto symbol = std::lower_bound(image.symbols.begin(), image.symbols.end(), begin_,
                                 [](const ImageSymbol& s, std::uint32_t address) { return s.address < address; });
  bool is_data = false;
  std::uint32_t from = begin_;
  for (; symbol != image.symbols.end() && symbol->address < end_; ++symbol) {
    if (symbol->kind != ImageSymbol::Kind::mapping || begins_data(*symbol) == is_data) continue;
    if (!is_data) decode_run(from, symbol->address);
    from = symbol->address;
    is_data = !is_data;
  }
  if (!is_data) decode_run(from, end_);
}

const Instruction* FunctionBody::at(std::uint32_t address) const {
  const auto found = std::lower_bound(instructions_.begin(), instructions_.end(), address,
                                      [](const Instruction& i, std::uint32_t a) { return i.address < a; });
  return found != instructions_.end() && found->address == address ? &*found : nullptr;
}

const Instruction* FunctionBody::before(std::uint32_t address) const {
  const auto found = std::lower_bound(instructions_.begin(), instructions_.end(), address,
                                      [](const Instruction& i, std::uint32_t a) { return i.address < a; });
  return found != instructions_.begin() && std::prev(found)->end() == address ? &*std::prev(found) : nullptr;
}

}  // namespace finemote::gen
