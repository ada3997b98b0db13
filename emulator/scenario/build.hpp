// Members of a scenario's rows in a few words each.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "emulator/scenario/grammar.hpp"

namespace finemote::scenario {

using Kind = Member::Kind;

inline Member row(Kind kind, const char* name, const char* unit, const char* summary) {
  Member member;
  member.name = name;
  member.kind = kind;
  member.unit = unit;
  member.summary = summary;
  return member;
}
inline Member flag(const char* name, const char* summary) { return row(Kind::flag, name, "", summary); }
inline Member text(const char* name, const char* summary) { return row(Kind::text, name, "", summary); }
inline Member vector3(const char* name, const char* unit, const char* summary) {
  return row(Kind::vector, name, unit, summary);
}
inline Member number(const char* name, const char* unit, const char* summary, double min = -kAny, double max = kAny) {
  Member member = row(Kind::number, name, unit, summary);
  member.min = min, member.max = max;
  return member;
}
inline Member positive(const char* name, const char* unit, const char* summary) {
  Member member = number(name, unit, summary, 0);
  member.above_min = true;
  return member;
}
inline Member integer(const char* name, const char* unit, const char* summary, double min, double max) {
  Member member = number(name, unit, summary, min, max);
  member.kind = Kind::integer;
  return member;
}
inline Member choice(const char* name, const char* summary, std::vector<std::string> choices) {
  Member member = row(Kind::choice, name, "", summary);
  member.choices = std::move(choices);
  return member;
}
/// The name of another part, which is `what` to this one.
inline Member part(const char* name, const char* what, const char* summary) {
  Member member = row(Kind::part, name, "", summary);
  member.choices = {what};
  return member;
}
inline Member port(const char* kind) {
  Member member = row(Kind::port, "port", "", "");
  member.choices = {kind};
  return member;
}
inline Member list(Kind kind, const char* name, const char* summary, std::vector<Member> members) {
  Member member = row(kind, name, "", summary);
  member.members = std::move(members);
  return member;
}
inline Member required(Member member) {
  member.required = true;
  return member;
}
inline Member family(Member member, int last) {
  member.last = last;
  return member;
}
/// Absent, it is this.
inline Member usually(double value, Member member) {
  member.usual = fmt::format("{}", value);
  return member;
}
inline Member usually(const std::vector<double>& values, Member member) {
  for (const double value : values) member.usual += fmt::format("{}{}", member.usual.empty() ? "[" : ", ", value);
  member.usual += "]";
  return member;
}
/// Absent, it is the first of its words.
inline Member first_usual(Member member) {
  member.usual = "\"" + member.choices[0] + "\"";
  return member;
}
/// Only one part can have it; `words` as Member::holds.
inline Member held(const char* words, Member member) {
  member.holds = words;
  return member;
}
/// Of a fault that lasts: it begins, or with false it ends.
inline Member until(const char* summary = "false ends it") { return flag("on", summary); }
inline Member count(const char* name) { return required(integer(name, "", "how many", 1, 1e9)); }
/// A fault of most kinds: frames are damaged, lost or refused. Ids are those of docs/timing.md "Assumptions".
inline constexpr const char* kBusErrors = "bus-errors";
/// A fault that violates another assumption than `bus-errors`.
inline Verb violating(const char* assumption, Verb fault) {
  fault.violates = assumption;
  return fault;
}
inline Verb with_member(Verb verb) {
  verb.needs_member = true;
  return verb;
}
inline std::vector<Member> operator+(std::vector<Member> a, const std::vector<Member>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace finemote::scenario
