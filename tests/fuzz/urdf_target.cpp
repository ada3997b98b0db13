// Any bytes as a URDF: files or a message with a place, and in the files no number that is none. Never a crash, a hang
// or an error of the tool itself.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "errors/pipeline.hpp"
#include "source_dir.hpp"

using namespace finemote::gen;

namespace {

bool is_word_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// `inf` or `nan` where a number should be, as printing a double leaves them behind.
bool has_no_number(std::string_view text) {
  for (const std::string_view word : {"inf", "nan"}) {
    for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      const bool is_begun = at > 0 && is_word_letter(text[at - 1]);
      const bool goes_on = at + 3 < text.size() && (is_word_letter(text[at + 3]) || text[at + 3] == '-');
      if (!is_begun && !goes_on) return true;
    }
  }
  return false;
}

struct Quoted {
  std::size_t begin, length;
};

std::vector<Quoted> quoted_values(const std::string& text) {
  std::vector<Quoted> found;
  for (auto at = text.find("=\""); at != std::string::npos; at = text.find("=\"", at)) {
    const auto close = text.find('"', at + 2);
    if (close == std::string::npos) break;
    found.push_back({at + 2, close - at - 2});
    at = close;
  }
  return found;
}

/// Another value of the text, or one that is odd, in place of a value: the document stays well formed.
void exchange_value(std::string& text, std::mt19937& random) {
  static const std::string kOdd[] = {
      "",     "0",    "-1",    "1e308", "1e-320",     "0 0 0", "1e200 0 0", "9223372036854775807",
      "1ns",  "1s",   "3600s", "0x7f",  "4294967296", "true",  "a",         "7us",
      "100%", "1kHz", "3.5ms", "255",   "-0",         "1 0",   "base_link", "builtin:x"};
  const auto values = quoted_values(text);
  if (values.empty()) return;
  const Quoted& changed = values[random() % values.size()];
  const Quoted& other = values[random() % values.size()];
  const std::string value =
      random() % 2 == 0 ? kOdd[random() % std::size(kOdd)] : text.substr(other.begin, other.length);
  text.replace(changed.begin, changed.length, value);
}

/// A line twice, or not at all.
void repeat_or_drop_line(std::string& text, std::mt19937& random) {
  const auto begin = text.rfind('\n', text.empty() ? 0 : random() % text.size());
  if (begin == std::string::npos) return;
  const auto end = std::min(text.find('\n', begin + 1), text.size());
  const std::string line = text.substr(begin, end - begin);
  random() % 2 == 0 ? text.insert(begin, line) : text.erase(begin, end - begin);
}

[[noreturn]] void fail(const std::string& what, const std::string& text) {
  std::cerr << what << "\n" << text << "\n";
  std::abort();
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

/// Bytes alone would seldom leave a document that can be read.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
  std::mt19937 random(seed);
  if (random() % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  std::string text(reinterpret_cast<const char*>(data), size);
  for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
    random() % 4 == 0 ? repeat_or_drop_line(text, random) : exchange_value(text, random);
  text.resize(std::min(text.size(), most));
  std::copy(text.begin(), text.end(), data);
  return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Pipeline pipeline(finemote::test::source_dir() + "/examples");
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Outcome outcome = pipeline.run(text);
  if (outcome.kind == Outcome::Kind::unexplained) fail("refused without a place", text + "\n" + outcome.said);
  const bool may_say_so = text.find("inf") != std::string::npos || text.find("nan") != std::string::npos;
  for (const OutputFile& file : outcome.files) {
    if (!may_say_so && has_no_number(file.text)) fail("no number in " + file.name, text + "\n" + file.text);
  }
  return 0;
}
