#include "generator/wcet/proven_bound.hpp"

#include "generator/wcet/certificate.hpp"
#include "generator/wcet/longest_path.hpp"

namespace finemote::gen::wcet {

std::optional<Cycles> proven_bound(const UnrolledGraph& graph) {
  const auto path = longest_path(graph);
  if (!path || !check_certificate(graph, path->potentials, path->bound).empty()) return std::nullopt;
  return path->bound;
}

}  // namespace finemote::gen::wcet
