#include "emulator/parts/foreign_node.hpp"

#include <memory>

namespace finemote::emulator {
namespace {

struct Node {
  World& world;
  CanLine& line;
  ForeignFrames frames;
  unsigned made = 0, sent = 0;
};

void make_next(const std::shared_ptr<Node>& node) {
  if (node->made == node->frames.count) return;
  ++node->made;
  node->line.request();
  node->world.after(node->frames.apart, [node] { make_next(node); });
}

/// All bits 0: with the most stuff bits.
std::optional<CanFrame> waiting(const Node& node) {
  if (node.sent == node.made) return std::nullopt;
  return CanFrame{node.frames.identifier, 8, {}};
}

}  // namespace

void flood(World& world, CanLine& line, const ForeignFrames& frames) {
  const auto node = std::make_shared<Node>(Node{world, line, frames});
  line.attach({[node] { return waiting(*node); },
               [node](const CanFrame&, CanOutcome outcome) {
                 if (outcome == CanOutcome::received) ++node->sent;
               },
               {}});
  make_next(node);
}

}  // namespace finemote::emulator
