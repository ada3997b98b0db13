// Rows of one class of elements: what a scenario says, with the function that does it.
#pragma once

#include <memory>
#include <utility>

#include "emulator/outfit/outfit.hpp"
#include "emulator/scenario/build.hpp"

namespace finemote::emulator {

/// @tparam Part  the class, derived from Element
template <class Part>
struct Rows {
  using Act = void (*)(Part& part, const Json& event);

  /// What bounds presume does not hold afterwards: no bus errors, or what `violating` names.
  static scenario::Verb fault(const char* name, const char* summary, std::vector<scenario::Member> members, Act act) {
    return {name, summary, std::move(members), on_part(act), scenario::kBusErrors};
  }
  /// Something every part has to stand.
  static scenario::Verb stimulus(const char* name, const char* summary, std::vector<scenario::Member> members,
                                 Act act) {
    return {name, summary, std::move(members), on_part(act), {}};
  }
  static scenario::Quantity value(const char* name, const char* unit, const char* summary, double (*look)(Part& part)) {
    return {name, unit, summary, [look](Element& part, unsigned) { return look(static_cast<Part&>(part)); }};
  }
  /// `name` followed by 0 to `last`.
  static scenario::Quantity values(const char* name, const char* unit, const char* summary, int last,
                                   double (*look)(Part& part, unsigned number)) {
    return {name, unit, summary,
            [look](Element& part, unsigned number) { return look(static_cast<Part&>(part), number); }, last};
  }
  static std::unique_ptr<Element> make(Outfit& outfit, const Json& part, const std::string& name) {
    return std::make_unique<Part>(outfit, part, name);
  }

 private:
  static scenario::Verb::Act on_part(Act act) {
    return
        [act](Outfit& outfit, const Json& event) { act(*outfit.find<Part>(need<std::string>(event, "part")), event); };
  }
};

}  // namespace finemote::emulator
