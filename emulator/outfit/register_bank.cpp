// An I2C part of plain registers, in place of one without a model.
#include "emulator/parts/register_bank.hpp"

#include "emulator/outfit/figures.hpp"
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

/// `r0`..`r255`: what the part is described by and asked for.
class RegisterElement : public Element {
 public:
  RegisterElement(Outfit& outfit, const Json& part, const std::string& name)
      : Element(outfit, name), model(need<std::uint8_t>(part, "address")) {
    set(part);
    model.on_sample = [this] { return begin_sample(0, now()); };
    model.on_read = [this](Tag sample) { end_sample(0, sample); };
    model.on_write = [this](unsigned number, WireByte byte) { record_output(number, byte.value, byte.tag); };
    outfit.line_of(part).attach(model);
  }
  void set(const Json& entry) {
    for (unsigned i = 0; i < model.bytes.size(); ++i) {
      const std::string name = "r" + std::to_string(i);
      model.bytes[i] = maybe(entry, name.c_str(), model.bytes[i]);
    }
  }

  RegisterBank model;
};

}  // namespace

Model register_bank() {
  using Row = Rows<RegisterElement>;
  const Member bytes = family(integer("r", "", "a register", 0, 255), 255);
  return {
      .type = "register_bank",
      .summary =
          "an I2C part of 256 plain registers, selected by the first byte written; replaces a part without a model",
      .figures = i2c_place() + std::vector{required(integer("address", "", "7 bits", 0, 127)), bytes},
      .one_of = i2c_where(),
      .verbs = {with_member(Row::stimulus("set", "sets registers", {bytes},
                                          [](RegisterElement& part, const Json& event) { part.set(event); }))},
      .values = {Row::values(
          "r", "", "a register", 255,
          [](RegisterElement& part, unsigned number) -> double { return part.model.bytes[number]; })},
      .make = Row::make,
  };
}

}  // namespace finemote::emulator
