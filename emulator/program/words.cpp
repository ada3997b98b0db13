#include "emulator/program/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "emulator/silicon/choice.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/diagnostic/roff.hpp"
#include "generator/units/units.hpp"
#include "generator/version.hpp"

namespace finemote::emulator {
namespace {

/// A whole number of up to `digits` digits, not 0; nothing where it is none.
std::optional<std::uint64_t> number(const std::string& word, std::size_t digits) {
  if (word.empty() || word.size() > digits || word.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const std::uint64_t value = std::stoull(word);
  return value == 0 ? std::nullopt : std::optional(value);
}

bool read_duration(const std::string& word, WatchOptions& options) {
  if (const auto ms = number(word, 8)) return options.duration_ns = *ms * 1'000'000, true;
  const auto duration = gen::units::parse_duration(word);
  if (!duration || (*duration).ns() <= 0 || (*duration).ns() > 86'400'000'000'000) return false;
  options.duration_ns = static_cast<std::uint64_t>((*duration).ns());
  return true;
}

bool read_crystal(const std::string& word, WatchOptions& options) {
  options.dead_crystal = word == "dead";
  if (options.dead_crystal) return true;
  const auto hz = number(word, 8);
  if (hz) options.crystal_hz = static_cast<std::uint32_t>(*hz);
  return hz.has_value();
}

/// Sets `flag` to whether the word is the first of the two it may be.
bool read_choice(const std::string& word, const char* on, const char* off, bool& flag) {
  flag = word == on;
  return flag || word == off;
}

/// The ways of `strict` or `strict:NAME,..`. @throws std::invalid_argument with what is wrong with it
bool read_silicon(const std::string& word, WatchOptions& options) {
  gen::Diagnostics diagnostics;
  const auto names = parse_silicon(word, diagnostics);
  if (!names) throw std::invalid_argument(gen::render_text(diagnostics, false));
  options.silicon = *names;
  return true;
}

bool read_seed(const std::string& word, WatchOptions& options) {
  const auto seed = number(word, 18);
  if (seed) options.seed = *seed;
  return seed.has_value();
}

struct Row {
  const char* key;
  const char* value;
  const char* help;
  bool (*read)(const std::string& word, WatchOptions& options);
};

constexpr Row kRows[] = {
    {"--image", "FILE", "an ELF file, a .hex, or a .bin that begins at 0x08000000; required",
     [](const std::string& word, WatchOptions& o) { return o.image = word, true; }},
    {"--board", "NAME|FILE", "a board: its crystal, wires and parts; without it the bare chip",
     [](const std::string& word, WatchOptions& o) { return o.board = word, true; }},
    {"--duration", "TIME", "from power-on, 1s if absent: 500ms, 2s; a bare number counts ms", read_duration},
    {"--scenario", "FILE", "parts, events and expectations",
     [](const std::string& word, WatchOptions& o) { return o.scenario = word, true; }},
    {"--crystal", "HZ|dead", "frequency of the crystal, or that it never starts; the board's if absent", read_crystal},
    {"--flash", "hit|miss", "fetches hit the flash accelerator, or miss it always",
     [](const std::string& word, WatchOptions& o) { return read_choice(word, "miss", "hit", o.flash_misses); }},
    {"--silicon", "WAYS", "strict, or strict:NAME,.. for a chip that uses the freedom its manual leaves", read_silicon},
    {"--seed", "N", "of how much it is; 1 if absent", read_seed},
    {"--format", "text|json", "lines of text, or one document finemote.emulator/1",
     [](const std::string& word, WatchOptions& o) { return read_choice(word, "json", "text", o.as_document); }},
};

}  // namespace

std::optional<WatchOptions> watch_options(const std::vector<std::string>& words) {
  WatchOptions options;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const auto row = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) { return r.key == words[i]; });
    if (row == std::end(kRows)) throw std::invalid_argument(fmt::format("there is no option '{}'", words[i]));
    if (i + 1 == words.size()) throw std::invalid_argument(fmt::format("{} takes {}", row->key, row->value));
    if (!row->read(words[i + 1], options))
      throw std::invalid_argument(fmt::format("{} takes {}, not '{}'", row->key, row->value, words[i + 1]));
  }
  if (options.image.empty()) return std::nullopt;
  return options;
}

std::string usage() {
  std::string text = "usage: finemote-emulator JOB RECORD\n       finemote-emulator --image FILE [OPTION]...\n";
  for (const Row& row : kRows) text += fmt::format("  {:<24} {}\n", fmt::format("{} {}", row.key, row.value), row.help);
  return text;
}

std::string manual_page() {
  std::string text = fmt::format(
      ".TH FINEMOTE-EMULATOR 1 \"\" \"finemote {}\" \"User Commands\"\n"
      ".SH NAME\nfinemote\\-emulator \\- a board with an STM32F407 that runs an image as it would be flashed\n"
      ".SH SYNOPSIS\n\\fBfinemote\\-emulator\\fR \\fB\\-\\-image\\fR \\fIFILE\\fR [\\fIOPTION\\fR]...\n.br\n"
      "\\fBfinemote\\-emulator\\fR \\fIJOB RECORD\\fR\n"
      ".SH DESCRIPTION\nRuns any image for the chip and prints what its pins, buses and parts did. The second form is "
      "how "
      "\\fBfinemote run\\fR\nstarts it: with a job, and the file that takes the record.\n.SH OPTIONS\n",
      gen::roff(gen::kVersion));
  for (const Row& row : kRows)
    text +=
        fmt::format(".TP\n\\fB{}\\fR \\fI{}\\fR\n{}.\n", gen::roff(row.key), gen::roff(row.value), gen::roff(row.help));
  return text +
         ".SH EXIT STATUS\n.TP\n0\nIt ran to the end, and as the scenario expects.\n.TP\n1\nIt was stopped, or not as "
         "expected.\n"
         ".TP\n2\nWrong usage, or a file that cannot be read.\n.SH SEE ALSO\n\\fBfinemote\\fR(1)\n";
}

}  // namespace finemote::emulator
