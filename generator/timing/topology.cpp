#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

Topology make_topology(const Model& model) {
  const std::size_t count = model.devices.size();
  Topology t;
  t.children.resize(count);
  t.root_of.resize(count);
  Table<Rank, std::size_t> tree(count);
  for (const Rank d : model.devices.ids()) {
    if (const auto parent = model.devices[d].parent) {
      t.children[*parent].push_back(d);
    } else {
      tree[d] = t.roots.size();
      t.roots.push_back(d);
    }
  }
  for (std::size_t position = count; position-- > 0;) {
    const Rank d{position};
    const auto parent = model.devices[d].parent;
    t.root_of[d] = parent ? t.root_of[*parent] : d;
  }
  t.leaves.resize(t.roots.size());
  for (const Rank d : model.devices.ids()) {
    if (t.children[d].empty()) t.leaves[tree[t.root_of[d]]].push_back(d);
  }
  return t;
}

}  // namespace finemote::gen::timing
