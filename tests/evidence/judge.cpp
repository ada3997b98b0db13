#include "tests/evidence/judge.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include "tests/evidence/explanations.hpp"

namespace finemote::evidence {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// The elements of a list, or the value alone.
std::vector<Json> elements_of(const Json& value) {
  if (!value.is_array()) return {value};
  return {value.begin(), value.end()};
}

/// Truth values as 0 and 1, hexadecimal text as its number; nothing where it is other text or an object.
std::optional<double> number_in(const Json& value) {
  if (value.is_number()) return value.get<double>();
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value.is_string() && value.get<std::string>().rfind("0x", 0) == 0) return number_of(value.get<std::string>());
  return {};
}

std::string text_of(const std::vector<double>& values) {
  std::ostringstream text;
  text.precision(9);
  for (const double value : values) text << (text.tellp() > 0 ? " " : "") << value;
  return text.str();
}

bool near(double expected, double found, const Finding& finding) {
  double apart = found - expected;
  if (finding.at_least) return apart >= 0;
  if (finding.turn != 0) apart -= finding.turn * std::round(apart / finding.turn);
  return std::abs(apart) <= finding.tolerance.absolute + finding.tolerance.relative * std::abs(expected) + 1e-12;
}

/// Of a list of names with spaces between them.
bool is_of(const Explanation& explanation, const std::string& protocol) {
  return (" " + std::string(explanation.protocols) + " ").find(" " + protocol + " ") != std::string::npos;
}

/// Collects what the fields of one vector come to.
class Comparison {
 public:
  Comparison(const Vector& vector, const Findings& findings) : vector_(vector), findings_(findings) {}

  Judgement result() {
    for (const std::string& key : vector_.unknown_keys) not_known(key);
    if (findings_.refused() && is_taken_by_source()) {
      differs("accepted", {1}, {0}, "refused");
    } else {
      for (const auto& [field, expected] : vector_.expected.items()) compare(field, expected);
    }
    for (const std::string& what : findings_.failed_checks()) differs(what, {}, {}, "does not hold");
    if (unknown_) {
      judgement_.verdict = Verdict::unknown_field;
    } else if (differs_) {
      judgement_.verdict = Verdict::differs;
    } else if (!judgement_.explanation.empty()) {
      judgement_.verdict = Verdict::explained;
    }
    return judgement_;
  }

 private:
  [[nodiscard]] bool is_taken_by_source() const {
    const Json& expected = vector_.expected;
    const bool refused = expected.contains("accepted") && expected.at("accepted") == false;
    const bool none = expected.contains("frames") && expected.at("frames") == 0;
    return !refused && !none;
  }

  void compare(const std::string& field, const Json& expected) {
    if (findings_.is_prose(field)) return;
    if (field == "writes") return compare_writes(settings_of(expected));
    const Findings::Named named = findings_.find(field);
    if (expected.is_null()) {
      if (named.finding != nullptr) differs(field, {}, {}, "has a value");
      return;
    }
    if (named.finding == nullptr) return unknown(field);
    if (!named.finding->texts.empty()) return compare_texts(field, expected, *named.finding);

    std::vector<double> wanted;
    for (const Json& element : elements_of(expected)) {
      const std::optional<double> number = number_in(element);
      if (!number) return differs(field, {}, {}, "is no number: " + expected.dump());
      wanted.push_back(*number * named.factor + named.offset);
    }
    const std::vector<double>& found = named.finding->values;
    const bool agrees = wanted.size() == found.size() &&
                        std::equal(wanted.begin(), wanted.end(), found.begin(),
                                   [&](double wants, double has) { return near(wants, has, *named.finding); });
    if (!agrees) differs(field, wanted, found, text_of(found) + " instead of " + text_of(wanted));
  }

  void compare_texts(const std::string& field, const Json& expected, const Finding& finding) {
    std::vector<std::string> wanted, found;
    for (const Json& element : elements_of(expected))
      wanted.push_back(lower(element.is_string() ? element.get<std::string>() : element.dump()));
    for (const std::string& text : finding.texts) found.push_back(lower(text));
    if (wanted != found) differs(field, {}, {}, Json(found).dump() + " instead of " + Json(wanted).dump());
  }

  void compare_writes(const std::vector<Setting>& wanted) {
    if (!findings_.writes) return unknown("writes");
    const auto equal = [](const Setting& a, const Setting& b) {
      return a.address == b.address && a.value == b.value && b.wait >= a.wait;
    };
    const std::vector<Setting>& found = *findings_.writes;
    if (!std::equal(wanted.begin(), wanted.end(), found.begin(), found.end(), equal))
      differs("writes", {}, {}, "registers, their order or waits");
  }

  void unknown(const std::string& field) {
    if (findings_.refused()) return differs(field, {}, {}, "the frame was refused");
    not_known(field);
  }
  void not_known(const std::string& name) {
    unknown_ = true;
    judgement_.remarks.push_back(name + ": nothing of ours has this name");
  }

  void differs(const std::string& field, const std::vector<double>& wanted, const std::vector<double>& found,
               const std::string& remark) {
    const Difference difference{&vector_, &findings_, field, wanted, found};
    for (const Explanation& explanation : explanations()) {
      if (!is_of(explanation, vector_.protocol) || !explanation.covers(difference)) continue;
      std::string& names = judgement_.explanation;
      if (names.find(explanation.name) == std::string::npos)
        names += (names.empty() ? "" : ",") + std::string(explanation.name);
      judgement_.explained_fields.push_back(field);
      return;
    }
    differs_ = true;
    judgement_.remarks.push_back(field + ": " + remark);
  }

  const Vector& vector_;
  const Findings& findings_;
  Judgement judgement_;
  bool unknown_ = false, differs_ = false;
};

}  // namespace

std::string Judgement::text() const {
  switch (verdict) {
    case Verdict::agree:
      return "agree";
    case Verdict::differs:
      return "differs";
    case Verdict::explained:
      return "explained " + explanation;
    case Verdict::no_decoder:
      return "no-decoder";
    case Verdict::unknown_field:
      return "unknown-field";
  }
  return {};
}

Decoder decoder_of(const std::string& protocol) {
  static const std::map<std::string, Decoder> kDecoders = {
      {"bmi088", decode_bmi088},   {"c610", decode_c610},       {"dr16", decode_dr16},   {"gm6020", decode_gm6020},
      {"h30", decode_h30},         {"ist8310", decode_ist8310}, {"m3508", decode_m3508}, {"ms5837", decode_ms5837},
      {"pca9685", decode_pca9685}, {"sbus", decode_sbus}};
  const auto found = kDecoders.find(protocol);
  return found != kDecoders.end() ? found->second : nullptr;
}

Judgement judge(const Vector& vector) {
  const Decoder decoder = decoder_of(vector.protocol);
  if (decoder == nullptr) return {Verdict::no_decoder, {}, {}, {}};
  try {
    return Comparison(vector, decoder(vector)).result();
  } catch (const Json::exception& error) {  // a field of another kind than those of this name
    return {Verdict::unknown_field, {}, {}, {error.what()}};
  }
}

}  // namespace finemote::evidence
