#include "generator/cli/option.hpp"

#include <sstream>

namespace finemote::gen {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> pieces;
  std::istringstream rest(text);
  for (std::string piece; std::getline(rest, piece, separator);) pieces.push_back(piece);
  return pieces;
}

}  // namespace

std::vector<std::string> names_of(const Option& option) { return split(option.names, ','); }

bool is_operand(const Option& option) { return option.names[0] != '-'; }

bool takes_value(const Option& option) {
  return !std::holds_alternative<bool Options::*>(option.value) && !std::holds_alternative<Refusal>(option.value);
}

std::vector<std::string> values_of(const Option& option) {
  if (const auto* choice = std::get_if<Choice>(&option.value)) return choice->words;
  return option.shown == nullptr ? std::vector<std::string>() : split(option.shown, '|');
}

}  // namespace finemote::gen
