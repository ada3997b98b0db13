#include "generator/bench_kit/record.hpp"

#include <algorithm>
#include <cstdint>
#include <set>

#include "generator/json/shallow.hpp"

namespace finemote::gen {
namespace {

using Json = nlohmann::ordered_json;

std::string text_at(const Json& object, const char* key) {
  return object.is_object() && object.contains(key) && object.at(key).is_string() ? object.at(key).get<std::string>()
                                                                                  : std::string();
}

/// A number that fits, not one beyond 64 bits with a sign.
bool is_value(const Json& it) {
  if (it.is_number_unsigned()) return it.get<std::uint64_t>() <= std::uint64_t{INT64_MAX};
  return it.is_null() || it.is_number_integer();
}

/// What expectation_of() makes: null, a number, or both ends of a range.
bool is_expectation(const Json& it) {
  const auto has_number = [&](const char* key) { return it.contains(key) && it.at(key).is_number(); };
  return it.is_null() || it.is_number() || (it.is_object() && has_number("min") && has_number("max"));
}

bool is_entry(const Json& it) {
  return it.is_object() && !text_at(it, "name").empty() && it.contains("value") && it.contains("ok") &&
         it.at("ok").is_boolean() && is_value(it.at("value")) && is_expectation(it.value("expected", Json()));
}

bool has_entry(const BenchRecord& record, const std::string& name) {
  return std::any_of(record.tests.begin(), record.tests.end(), [&](const auto& it) { return it.name == name; });
}

/// Which of two tests of one name is meant cannot be told.
bool names_one_twice(const BenchRecord& record) {
  std::set<std::string> names;
  return !std::all_of(record.tests.begin(), record.tests.end(),
                      [&](const auto& it) { return names.insert(it.name).second; });
}

/// Of one object, and of those in it, each member has a name of its own: nobody can tell which of two is meant. Nor is
/// a record nested deeper than any file of ours.
std::optional<Json> parse_once_named(const std::string& text) {
  std::vector<std::set<std::string>> members;
  bool is_twice = false;
  const auto watch = [&](Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) members.emplace_back();
    if (event == Json::parse_event_t::object_end) members.pop_back();
    if (event == Json::parse_event_t::key && !members.back().insert(parsed.get<std::string>()).second) is_twice = true;
  };
  Json parsed = json::parse_shallow<Json>(text, watch);
  return is_twice || parsed.is_discarded() ? std::nullopt : std::optional(std::move(parsed));
}

std::optional<BenchRecord> record_of(const Json& document) {
  if (!document.is_object() || text_at(document, "schema") != kBenchFormat) return std::nullopt;
  const auto tests = document.find("tests");
  if (tests == document.end() || !tests->is_array()) return std::nullopt;
  BenchRecord record{text_at(document, "board"), text_at(document, "robot"), text_at(document, "plan"), {}, {}};
  for (const Json& it : *tests) {
    if (!is_entry(it)) return std::nullopt;
    BenchRecord::Entry entry{text_at(it, "name"), std::nullopt, it.value("expected", Json()), it.at("ok").get<bool>(),
                             text_at(it, "why")};
    if (!it.at("value").is_null()) entry.value = it.at("value").get<std::int64_t>();
    record.tests.push_back(std::move(entry));
  }
  const Json not_done = document.value("not_done", Json::array());
  if (!not_done.is_array()) return std::nullopt;
  for (const Json& it : not_done) {
    if (text_at(it, "name").empty()) return std::nullopt;
    record.not_done.emplace_back(text_at(it, "name"), text_at(it, "why"));
  }
  if (names_one_twice(record)) return std::nullopt;
  return record;
}

/// Where the object that begins here ends; npos: nowhere. No text of a record holds a brace.
std::size_t end_of_object(const std::string& text, std::size_t begin) {
  int depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return std::string::npos;
}

/// Whether an expectation of a record allows the value.
bool allows(const Json& expected, std::int64_t value) {
  if (expected.is_null()) return true;
  if (expected.is_number()) return expected.get<double>() == static_cast<double>(value);
  if (!expected.is_object()) return false;
  const auto bound = [&](const char* key, double without) {
    const auto it = expected.find(key);
    return it != expected.end() && it->is_number() ? it->get<double>() : without;
  };
  const auto number = static_cast<double>(value);
  return number >= bound("min", number) && number <= bound("max", number);
}

BenchVerdict verdict_of(const BenchTest& test, const BenchRecord::Entry* entry) {
  BenchVerdict verdict{test.name, {}, expectation_of(test), false, ground_words(test.ground), test.source, {}};
  if (entry == nullptr) {
    verdict.why = "not in the record";
    return verdict;
  }
  verdict.value = entry->value;
  verdict.is_ok = entry->was_ok && entry->value && allows(verdict.expected, *entry->value);
  if (!entry->value) verdict.why = entry->why.empty() ? "not done" : entry->why;
  return verdict;
}

/// A test that only the record knows: the image may be newer.
BenchVerdict verdict_of_stranger(const BenchRecord::Entry& entry) {
  BenchVerdict verdict{entry.name, entry.value, entry.expected, false, "the record's own", "", entry.why};
  verdict.is_ok = entry.was_ok && entry.value && allows(entry.expected, *entry.value);
  return verdict;
}

}  // namespace

Json expectation_of(const BenchTest& test) {
  if (!test.is_judged) return nullptr;
  if (test.least == test.most) return test.least;
  return {{"min", test.least}, {"max", test.most}};
}

std::optional<BenchRecord> find_bench_record(const std::string& text) {
  if (json::parse_shallow<Json>(text).is_object()) {
    const auto whole = parse_once_named(text);
    return whole ? record_of(*whole) : std::nullopt;
  }
  const std::string begin = "{\"schema\":\"" + std::string(kBenchFormat) + "\"";
  for (std::size_t at = text.rfind(begin); at != std::string::npos; at = text.rfind(begin, at - 1)) {
    const std::size_t end = end_of_object(text, at);
    if (end != std::string::npos) {
      const auto document = parse_once_named(text.substr(at, end - at));
      auto record = document ? record_of(*document) : std::nullopt;
      if (record) return record;
    }
    if (at == 0) break;
  }
  return std::nullopt;
}

bool BenchJudgement::is_good() const {
  return std::all_of(tests.begin(), tests.end(), [](const BenchVerdict& it) { return it.is_ok; });
}

BenchJudgement judge_bench(const BenchRecord& record, const BenchPlan& plan) {
  BenchJudgement judgement;
  for (const BenchTest& test : plan.tests) {
    const auto lacks = std::find_if(record.not_done.begin(), record.not_done.end(),
                                    [&](const auto& it) { return it.first == test.name; });
    if (lacks != record.not_done.end() && !test.needs.empty() && !has_entry(record, test.name)) {
      judgement.not_done.push_back(*lacks);
      continue;
    }
    const auto entry = std::find_if(record.tests.begin(), record.tests.end(),
                                    [&](const BenchRecord::Entry& it) { return it.name == test.name; });
    judgement.tests.push_back(verdict_of(test, entry == record.tests.end() ? nullptr : &*entry));
  }
  for (const BenchRecord::Entry& entry : record.tests) {
    const bool is_known =
        std::any_of(plan.tests.begin(), plan.tests.end(), [&](const BenchTest& it) { return it.name == entry.name; });
    if (!is_known) judgement.tests.push_back(verdict_of_stranger(entry));
  }
  return judgement;
}

}  // namespace finemote::gen
