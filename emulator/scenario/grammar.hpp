// What a scenario can say: the parts it may place, what can happen to them, and what can be looked at.
//
// One row each, which also holds the function that does it: rows of parts stand with their behaviour in
// emulator/outfit, one file per part. The checker, the JSON Schema (schemas/scenario.schema.json), the tables of
// docs/reference/emulator.md and what the emulated board does follow from them.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostic/diagnostics.hpp"
#include "generator/json/value.hpp"

namespace finemote::emulator {
class Element;
class Outfit;
}  // namespace finemote::emulator

namespace finemote::scenario {

struct World;  // check.hpp

inline constexpr const char* kFormat = "finemote.scenario/1";
inline constexpr double kAny = std::numeric_limits<double>::infinity();
inline constexpr double kLongest = 86'400e9;  ///< ns: a day; latest time a scenario can name

/// A member of an entry: what may stand there.
struct Member {
  enum class Kind {
    flag,       ///< true or false
    integer,    ///< also written 1e9
    number,     ///<
    text,       ///<
    choice,     ///< one of `choices`
    vector,     ///< three numbers
    six,        ///< six numbers: xx xy xz yy yz zz
    part,       ///< name of a part that is one of `choices`; of any where there are none
    reference,  ///< name of a part this entry stands for: it may turn nothing
    port,       ///< a port of the kind `choices[0]`
    pin,        ///< PA0 to PI11
    object,     ///< of `members`
    list,       ///< of objects of `members`
  };
  std::string name;
  Kind kind = Kind::text;
  std::string unit, summary;
  std::string usual;  ///< what stands for it where it is absent, as JSON; empty: nothing
  std::string
      holds;  ///< what only one part can have, at the end of `'imu' already ...`: `has chip select`; empty: none
  double min = -kAny, max = kAny;
  bool above_min = false;  ///< `min` itself is too small
  bool required = false;
  int last = -1;  ///< not negative: a family, the name followed by 0 to `last`
  std::vector<std::string> choices;
  std::vector<Member> members;
  std::vector<std::string> one_of;  ///< of an object: exactly one of these members
};

/// Something that can happen: the row behind a `do`.
struct Verb {
  /// Makes it happen. The event was checked.
  using Act = std::function<void(emulator::Outfit& outfit, const nlohmann::ordered_json& event)>;
  std::string name, summary;
  std::vector<Member> members;
  Act act;
  std::string violates;       ///< id of the assumption of the bounds that does not hold any more; empty: a stimulus
  bool needs_member = false;  ///< says nothing without at least one of its members
};

/// Something that can be looked at: the row behind a `value`.
struct Quantity {
  /// Its value now; `number`: which one of a family, else 0.
  using Look = std::function<double(emulator::Element& part, unsigned number)>;
  std::string name, unit, summary;
  Look look;
  int last = -1;  ///< as Member::last
};

/// A part or plant that can stand in a scenario.
struct Model {
  using Entry = nlohmann::ordered_json;
  /// Hangs a part on the board. Its entry was checked, and has what is usual for every absent figure.
  using Make = std::unique_ptr<emulator::Element> (*)(emulator::Outfit& outfit, const Entry& part,
                                                      const std::string& name);
  /// Reports figures of an entry that do not fit each other.
  using Check = void (*)(const gen::json::Value& entry, const Model& model, const World& world,
                         gen::Diagnostics& diagnostics);
  std::string type, summary;
  std::vector<std::string> is = {};  ///< what others can refer to it as: body, hull, mux, pwm, shaft
  std::vector<Member> figures = {};  ///< beside `type` and `name`
  std::vector<std::string> one_of = {};
  double clock_tolerance_ppm = 0;  ///< of its own clock, both ways; 0: it has none
  std::vector<Verb> verbs = {};
  std::vector<Quantity> values = {};
  Make make = nullptr;
  Check check = nullptr;  ///< null: single values say it all
};

/// A kind of port, with the ports of that kind and what can happen at them.
struct PortKind {
  std::string name, title;
  std::vector<std::string> ports;
  std::vector<Verb> verbs;
};

/// What an event can happen to, by the member that names it.
struct Target {
  std::string key;    ///< part, port or pin; empty: the board as a whole
  std::string title;  ///< type of the part, kind of the port, `pin`, `the board`
  const PortKind* port = nullptr;
  const std::vector<Verb>* verbs;
};

/// All models, in the order of the reference page.
const std::vector<Model>& models();
/// Null: there is no model of this type.
const Model* find_model(std::string_view type);
const std::vector<PortKind>& port_kinds();
/// Null: the board has no such port.
const PortKind* kind_of_port(std::string_view port);
/// What can happen to a pin of the chip, and to the board as a whole.
const std::vector<Verb>& pin_verbs();
const std::vector<Verb>& board_verbs();
/// Everything something can happen to: models, kinds of ports, pins, the board.
std::vector<Target> targets();
/// Members of every part beside its model's figures.
const std::vector<Member>& part_members();
/// Members of every event beside those of its verb and its target, and of every expectation.
const std::vector<Member>& event_members();
const std::vector<Member>& expectation_members();

/// Null: none of this name.
const Verb* find_verb(const std::vector<Verb>& verbs, std::string_view name);
/// The row of a member or quantity whose name, or family, this is; null: none.
const Member* find_member(const std::vector<Member>& members, std::string_view name);
const Quantity* find_quantity(const std::vector<Quantity>& values, std::string_view name);
/// Which one of its family a name of this stem is; 0: there is no family.
unsigned number_in_family(std::string_view name, std::string_view stem);
/// The names a row stands for: its own, or those of its family.
std::vector<std::string> names_of(const std::string& name, int last);

}  // namespace finemote::scenario
