#include "generator/timing/topology.hpp"

namespace finemote::gen::timing {

Topology make_topology(const Model& model) {
  const std::size_t n = model.devices.size();
  Topology t;
  t.children.resize(n);
  t.root_of.resize(n);
  std::vector<std::size_t> tree(n);
  for (std::size_t d = 0; d < n; ++d) {
    if (const auto parent = model.devices[d].parent) {
      t.children[*parent].push_back(d);
    } else {
      tree[d] = t.roots.size();
      t.roots.push_back(d);
    }
  }
  for (std::size_t d = n; d-- > 0;) {
    const auto parent = model.devices[d].parent;
    t.root_of[d] = parent ? t.root_of[*parent] : d;
  }
  t.leaves.resize(t.roots.size());
  for (std::size_t d = 0; d < n; ++d) {
    if (t.children[d].empty()) t.leaves[tree[t.root_of[d]]].push_back(d);
  }
  return t;
}

}  // namespace finemote::gen::timing
