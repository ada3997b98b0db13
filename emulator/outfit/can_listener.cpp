// A CAN node without a program: it takes part in the bus, and that is all.
#include "emulator/outfit/models.hpp"
#include "emulator/outfit/rows.hpp"

namespace finemote::emulator {
namespace {

using namespace scenario;

class CanListener : public Element {
 public:
  CanListener(Outfit& outfit, const Json& part, const std::string& name) : Element(outfit, name) {
    outfit.can_of(part).attach({});
  }
};

}  // namespace

Model can_listener() {
  return {
      .type = "can_listener",
      .summary = "acknowledges every frame and sends none; `run` places one for every device on CAN without a model",
      .figures = {required(port("can"))},
      .make = Rows<CanListener>::make,
  };
}

}  // namespace finemote::emulator
