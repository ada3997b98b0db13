// Text that a hint offers to paste is taken: it is put into the robot, and nothing is said of it any more.
#include <fmt/format.h>

#include <optional>
#include <regex>

#include "cases.hpp"
#include "catch.hpp"
#include "generator/bus/bus_kind.hpp"
#include "generator/bus/rate_form.hpp"
#include "generator/descriptor/library.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/model/offers.hpp"
#include "tests/read.hpp"

using namespace finemote::gen;
using namespace finemote::test;

namespace {

/// A text after an offer was taken, and where the offered words stand in it.
struct Pasted {
  std::string text;
  std::size_t begin = 0, end = 0;
};

std::size_t offset_of(const std::string& text, const Position& at) {
  std::size_t offset = 0;
  for (std::uint32_t line = 1; line < at.line; ++line) offset = text.find('\n', offset) + 1;
  return offset + at.column - 1;
}

Pasted replaced(const std::string& text, std::size_t begin, std::size_t length, const std::string& offer) {
  return {text.substr(0, begin) + offer + text.substr(begin + length), begin, begin + offer.size()};
}

/// `attribute="value"`, in the tag around `offset`: instead of the one there, else after the tag's name.
Pasted with_attribute(const std::string& text, std::size_t offset, const std::string& name, const std::string& value) {
  const std::size_t tag = text.rfind('<', offset);
  const std::size_t close = text.find('>', tag);
  const std::size_t there = text.find(" " + name + "=\"", tag);
  if (there < close) {
    const std::size_t begin = there + name.size() + 3;
    return replaced(text, begin, text.find('"', begin) - begin, value);
  }
  const std::size_t behind = text.find_first_of(" />", tag + 1);
  Pasted pasted = replaced(text, behind, 0, fmt::format(" {}=\"{}\"", name, value));
  pasted.begin += name.size() + 3;
  return pasted;
}

/// Every text that the hint offers, pasted where the finding points.
std::vector<Pasted> take_offers(const std::string& text, const Diagnostic& finding, const std::string& hint) {
  static const std::regex kNames("^(?:did you mean|valid here:) (.*)$"), kName("'([^']+)'"),
      kAttribute("^(?:add|write)(?: for example)? ([a-z_]+)=\"([^\"]*)\""), kValues("^write ('.*)$");
  std::vector<Pasted> all;
  const std::size_t begin = offset_of(text, finding.at);
  std::smatch found;
  const bool has_names = std::regex_search(hint, found, kNames) || std::regex_search(hint, found, kValues);
  if (has_names) {
    if (text[begin] == '<') return {};  // names of elements end twice
    const std::string names = std::string(found[1]).substr(0, std::string(found[1]).find(';'));
    for (std::sregex_iterator name(names.begin(), names.end(), kName), end; name != end; ++name)
      all.push_back(replaced(text, begin, finding.length, (*name)[1]));
  } else if (std::regex_search(hint, found, kAttribute) && found[2] != "...") {  // "..." is for the user to fill in
    all.push_back(with_attribute(text, begin, found[1], found[2]));
  }
  return all;
}

/// The first finding that points into the pasted words.
std::optional<Diagnostic> objection(const Case& test, const Pasted& pasted) {
  Said said;
  examine(test, pasted.text, said);
  for (const Diagnostic& finding : said.diagnostics.in_file_order()) {
    if (finding.at.file == nullptr || finding.at.file->name != test.display || finding.at.line == 0) continue;
    const std::size_t at = offset_of(pasted.text, finding.at);
    if (at >= pasted.begin && at < pasted.end) return finding;
  }
  return std::nullopt;
}

/// Takes every offer made for the text; returns how many there were.
std::size_t check_offers(const Case& test, const std::string& text) {
  Said said;
  examine(test, text, said);
  std::size_t count = 0;
  for (const Diagnostic& finding : said.diagnostics.in_file_order()) {
    if (finding.at.file == nullptr || finding.at.file->name != test.display || finding.at.column == 0) continue;
    for (const std::string& hint : finding.hints) {
      for (const Pasted& pasted : take_offers(text, finding, hint)) {
        ++count;
        const auto refused = objection(test, pasted);
        if (!refused) continue;
        FAIL_CHECK(test.name << ": " << finding.message << "\n  hint: " << hint
                             << "\n  then: " << code_name(refused->code) << ": " << refused->message << "\n"
                             << pasted.text);
      }
    }
  }
  return count;
}

}  // namespace

TEST_CASE("what the hints of all cases offer is taken") {
  std::size_t count = 0;
  for (const std::string& name : case_names()) {
    const Case test = find_case(name);
    count += check_offers(test, finemote::test::read(test.input));
  }
  CHECK(count > 100);
}

namespace {

/// A robot with one bus and one device on it; without a port when that is empty.
std::string robot_text(const std::string& board, BusKind kind, const std::string& port, const std::string& type) {
  return fmt::format(
      "<robot name=\"r\"><link name=\"l\"/>\n<finemote version=\"1\">\n<board name=\"{}\"/>\n"
      "<bus name=\"b\" type=\"{}\"{}/>\n<device name=\"d\" type=\"{}\" period=\"10ms\" bus=\"b\"/>\n"
      "</finemote>\n</robot>\n",
      board, bus_kind_name(kind), port.empty() ? "" : fmt::format(" port=\"{}\"", port), type);
}

/// All that one run offers at the bus together: port and rate.
std::size_t check_together(const Case& test, std::string text) {
  Said said;
  examine(test, text, said);
  std::size_t count = 0;
  for (const Diagnostic& finding : said.diagnostics.in_file_order()) {
    if (finding.at.line != 4) continue;
    for (const std::string& hint : finding.hints) {
      for (const Pasted& pasted : take_offers(text, finding, hint)) text = pasted.text, ++count;
    }
  }
  Said then;
  examine(test, text, then);
  for (const Diagnostic& finding : then.diagnostics.in_file_order()) {
    if (finding.at.line == 4 || finding.code == code::rate_unreachable) FAIL_CHECK(text << finding.message);
  }
  return count;
}

}  // namespace

TEST_CASE("the rate offered for a bus without one is taken, on every port and with every device") {
  Said said;
  auto library = load_library({source_folder().string(), {}, {}, {}}, said.sources, said.diagnostics);
  REQUIRE(library);
  std::size_t count = 0;
  for (const std::string& board_name : board_names(*library)) {
    const Board* board = find_board(*library, board_name, said.sources, said.diagnostics);
    REQUIRE(board != nullptr);
    for (const std::string& type_name : device_type_names(*library)) {
      const DeviceType* type = find_device_type(*library, type_name, said.sources, said.diagnostics);
      REQUIRE(type != nullptr);
      for (const Port& port : board->ports) {
        for (const BusKind kind : port.kinds) {
          const bool fits = std::find(type->buses.begin(), type->buses.end(), kind) != type->buses.end();
          if (!fits || rate_attribute(kind).empty()) continue;
          const Case test{type_name, {}, {}, {}, "r.urdf"};
          count += check_offers(test, robot_text(board_name, kind, port.name, type_name));
          count += check_together(test, robot_text(board_name, kind, port.name, type_name));
          count += check_together(test, robot_text(board_name, kind, {}, type_name));
        }
      }
    }
  }
  CHECK(count > 50);
}
