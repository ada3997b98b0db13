#include "generator/document/contact_use.hpp"

#include <algorithm>

namespace finemote::gen {
namespace {

void add_uses(const Contact& contact, const Port& port, std::vector<PortUse>& uses) {
  if (!contact.port.empty() && contact.port == port.name) uses.push_back({&port, ""});
  if (contact.pin.empty()) return;
  for (const PortPin& pin : port.pins) {
    if (pin.pin == contact.pin) uses.push_back({&port, pin.signal});
  }
  if (std::find(port.selects.begin(), port.selects.end(), contact.pin) != port.selects.end())
    uses.push_back({&port, "select"});
}

}  // namespace

ContactUse use_of(const Contact& contact, const Board& board) {
  ContactUse use;
  for (const Port& port : board.ports) add_uses(contact, port, use.ports);
  if (contact.pin.empty()) return use;
  use.named = board.named_pin(contact.pin);
  use.reserved = board.reserved_pin(contact.pin);
  return use;
}

}  // namespace finemote::gen
