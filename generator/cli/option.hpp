// One option, flag or operand of the command line: its words, where its value goes, and what help says of it.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "generator/cli/options.hpp"

namespace finemote::gen {

/// One of few words; the last one given counts.
struct Choice {
  std::vector<std::string> words;
  void (*choose)(Options& options, std::size_t word);  ///< called with the index of the word that was given
};

/// An option that is understood and refused.
struct Refusal {
  const char* why;
};

/// Where a value goes: a flag, a text, texts, numbers.
using Value = std::variant<bool Options::*, std::string Options::*, std::vector<std::string> Options::*, int Options::*,
                           std::uint64_t Options::*, Choice, Refusal>;

struct Option {
  enum class Need { optional, required };

  const char* names;  ///< `-o,--output`; of an operand its name in help: `IN`
  Value value;
  const char* help;
  Need need = Need::optional;
  const char* shown = nullptr;      ///< in help, instead of the type of the value: `paper|tight|target`
  const char* excludes = nullptr;   ///< an option before it in the table that cannot be given beside it
  const char* listed_by = nullptr;  ///< the command whose lines begin with the possible values: `board show`
};

/// `-o` and `--output` of `-o,--output`; of an operand its name in help.
std::vector<std::string> names_of(const Option& option);

bool is_operand(const Option& option);

/// Whether a word follows the option.
bool takes_value(const Option& option);

/// The values, where there are few and they are known here; else empty.
std::vector<std::string> values_of(const Option& option);

}  // namespace finemote::gen
