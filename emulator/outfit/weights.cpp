// The weight of what hangs at joints that motors turn.
#include "emulator/plants/weights.hpp"

#include <map>
#include <set>

#include "emulator/outfit/bodies.hpp"
#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"
#include "emulator/outfit/seat.hpp"
#include "emulator/scenario/figures.hpp"
#include "generator/diagnostic/code_scenario.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class WeightsElement : public Element {
 public:
  WeightsElement(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name), part_(part) {}
  void connect() override {
    weights_ = std::make_unique<Weights>(body_of(outfit(), part_));
    for (const Json& entry : need<Json>(part_, "joints")) add(entry);
    keep_stepping(outfit().board().world(), *weights_);
  }

 private:
  void add(const Json& entry) {
    Weights::Node node;
    node.shaft = shaft_of(outfit(), entry);
    if (entry.contains("before")) node.before = numbers_.at(need<std::string>(entry, "before"));
    node.way = way_of(outfit(), maybe(entry, "way", Json::array()));
    node.axis = vector(entry, "axis").normalized();
    node.mass = need<double>(entry, "mass");
    node.centre = vector(entry, "centre");
    numbers_[need<std::string>(entry, "part")] = weights_->add(node);
  }

  Json part_;
  std::unique_ptr<Weights> weights_;
  std::map<std::string, std::size_t> numbers_;
};

std::vector<Member> joint() {
  return {required(row(Kind::reference, "part", "", "that turns it")),
          row(Kind::reference, "before", "", "the part of the joint that carries it"),
          list(Kind::list, "way", "from there, or from the body", joint_steps()),
          usually({1, 0, 0}, vector3("axis", "", "")),
          required(number("mass", "kg", "", 0)),
          vector3("centre", "m", "of that mass")};
}

/// A joint is listed after the one that carries it.
void check_joint_order(const gen::json::Value& entry, const Model&, const scenario::World&,
                       gen::Diagnostics& diagnostics) {
  const gen::json::Value* joints = entry.find("joints");
  std::set<std::string> above;
  for (const gen::json::Value& joint : joints == nullptr ? std::vector<gen::json::Value>() : joints->items) {
    const gen::json::Value *part = word_in(joint, "part"), *before = word_in(joint, "before");
    if (before != nullptr && above.count(before->text) == 0)
      diagnostics
          .error(gen::code::bad_scenario, before->at,
                 fmt::format("no joint above this one is that of '{}'", before->text))
          .underline(before->length)
          .note("joints are listed from the body outwards");
    if (part != nullptr) above.insert(part->text);
  }
}

}  // namespace

Model weights() {
  return {
      .type = "weights",
      .summary = "applies the weight behind driven joints to them, on a still or moving body",
      .figures = {required(part("body", "body", "")), required(list(Kind::list, "joints", "", joint()))},
      .make = Rows<WeightsElement>::make,
      .check = check_joint_order,
  };
}

}  // namespace finemote::emulator
