// Holds evidence_test to what it says: every field is compared, every explanation is needed, the page shows it all.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "catch.hpp"
#include "source_dir.hpp"
#include "tests/evidence/explanations.hpp"
#include "tests/evidence/page.hpp"
#include "tests/read.hpp"
#include "tests/rewrites.hpp"
#include "tests/temporary_folder.hpp"

using namespace finemote::evidence;
using finemote::test::read;

namespace {

const std::string kFolder = finemote::test::source_dir() + "/tests/evidence";

/// Another value, far from the one it was.
Json spoiled(const Json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number()) return value.get<double>() * 1000 + 17;
  const std::string text = value.get<std::string>();
  if (text.rfind("0x", 0) != 0) return text + "x";
  return "0x" + hexadecimal({static_cast<std::uint8_t>(number_of(text) + 1)});
}

/// Calls `judge_it` with the vector once per value of its expectations, with that value spoiled.
template <class JudgeIt>
void spoil_each(const Vector& vector, JudgeIt&& judge_it) {
  for (const auto& [field, value] : vector.expected.items()) {
    Vector other = vector;
    if (!value.is_structured()) {
      other.expected[field] = spoiled(value);
      judge_it(field, other);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      Json& element = other.expected[field][i];
      const Json before = element;
      Json& part = element.is_object() ? element["value"] : element;
      part = spoiled(part);
      judge_it(field, other);
      element = before;
    }
  }
}

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

TEST_CASE("each value that a source gives is compared: another one is found out") {
  unsigned values = 0;
  for (const Vector& vector : read_vectors(kFolder)) {
    const Judgement whole = judge(vector);
    if (whole.verdict == Verdict::no_decoder || is_in(whole.explained_fields, "accepted")) continue;
    spoil_each(vector, [&](const std::string& field, const Vector& other) {
      if (is_in(whole.explained_fields, field)) return;
      INFO(vector.protocol << "/" << vector.name << " " << field);
      const Verdict verdict = judge(other).verdict;
      CHECK((verdict == Verdict::differs || verdict == Verdict::unknown_field));
      ++values;
    });
  }
  CHECK(values > 150);
}

TEST_CASE("bytes that are not those of the vector are found out") {
  for (const Vector& vector : read_vectors(kFolder)) {
    const Judgement whole = judge(vector);
    if (whole.verdict != Verdict::agree || vector.bursts.size() != 1) continue;
    const bool refused = vector.expected.contains("frames") ? vector.expected.at("frames") == 0
                                                            : vector.expected.value("accepted", true) == false;
    if (refused) continue;
    INFO(vector.protocol << "/" << vector.name);
    unsigned found_out = 0;
    for (std::size_t i = 0; i < vector.bursts[0].bytes.size(); ++i) {
      Vector other = vector;
      other.bursts[0].bytes[i] ^= 0x55;
      found_out += judge(other).verdict != Verdict::agree ? 1 : 0;
    }
    CHECK(2 * found_out > vector.bursts[0].bytes.size());
  }
}

TEST_CASE("a field or a key that nobody knows is said so") {
  std::vector<Vector> vectors = read_vectors(kFolder);
  const auto basic =
      std::find_if(vectors.begin(), vectors.end(), [](const Vector& v) { return v.name == "zklapow_basic"; });
  REQUIRE(basic != vectors.end());
  CHECK(judge(*basic).text() == "agree");
  Vector other = *basic;
  other.expected["colour"] = 7;
  CHECK(judge(other).text() == "unknown-field");
  other = *basic;
  other.unknown_keys.push_back("transactions.pause");
  CHECK(judge(other).text() == "unknown-field");
  other = *basic;
  other.protocol = "morse";
  CHECK(judge(other).text() == "no-decoder");
}

TEST_CASE("a vector that is not as the format says is said so, and the others are judged") {
  const finemote::test::TemporaryFolder folder;
  std::ofstream(folder.path("c610.json")) << R"([
    {"name": "odd", "bytes": "0g", "can_id": "0x201", "expected": {"angle_raw": 1}},
    {"name": "kind", "bytes": "03e8ff9c00642b00", "can_id": "0x201", "expected": {"angle_unwrapped_raw": {"a": 1}}},
    {"name": "key", "octets": "03e8ff9c00642b00", "can_id": "0x201", "expected": {}},
    {"name": "good", "bytes": "03e8ff9c00642b00", "can_id": "0x201", "expected": {"angle_raw": 1000}}])";
  std::vector<std::string> texts;
  for (const Vector& vector : read_vectors(folder.path())) texts.push_back(judge(vector).text());
  CHECK(texts == std::vector<std::string>{"unknown-field", "differs", "unknown-field", "agree"});
}

TEST_CASE("every explanation is needed by a vector") {
  std::set<std::string> needed;
  for (const Vector& vector : read_vectors(kFolder)) {
    const std::string names = judge(vector).explanation;
    for (const Explanation& explanation : explanations()) {
      if (names.find(explanation.name) != std::string::npos) needed.insert(explanation.name);
    }
  }
  for (const Explanation& explanation : explanations()) CHECK(needed.count(explanation.name) == 1);
}

TEST_CASE("the page of the evidence shows what the vectors come to") {
  const std::string path = finemote::test::source_dir() + "/docs/reference/evidence.md";
  const std::string page = read(path);
  const std::string sources = table_of_sources(read_vectors(kFolder));
  const std::string expected =
      with_table(with_table(page, "sources", sources), "explanations", table_of_explanations());
  if (finemote::test::rewrites()) std::ofstream(path, std::ios::binary) << expected;
  CHECK(read(path) == expected);
}
