#include "generator/timing/check_cycles.hpp"

#include <fmt/format.h>

namespace finemote::gen::timing {

void check_cycles(const Model& model, Diagnostics& diagnostics) {
  enum class Mark : char { fresh, open, done };
  const std::size_t count = model.devices.size();
  Table<Rank, std::vector<Rank>> producers(count);
  for (const Rank d : model.devices.ids()) {
    if (const auto parent = model.devices[d].parent) producers[*parent].push_back(d);
    for (const Rank observed : model.devices[d].reads) producers[d].push_back(observed);
  }
  Table<Rank, Mark> mark(count, Mark::fresh);
  std::vector<std::pair<Rank, std::size_t>> stack;
  for (const Rank start : model.devices.ids()) {
    if (mark[start] != Mark::fresh) continue;
    stack.assign(1, {start, 0});
    mark[start] = Mark::open;
    while (!stack.empty()) {
      auto& [device, next] = stack.back();
      if (next == producers[device].size()) {
        mark[device] = Mark::done;
        stack.pop_back();
        continue;
      }
      const Rank producer = producers[device][next++];
      if (mark[producer] == Mark::open) {
        const Device& d = model.devices[device];
        diagnostics.error(code::timing_cycle, d.at, fmt::format("device '{}' reads data made from its own", d.name));
      } else if (mark[producer] == Mark::fresh) {
        mark[producer] = Mark::open;
        stack.emplace_back(producer, 0);
      }
    }
  }
}

}  // namespace finemote::gen::timing
