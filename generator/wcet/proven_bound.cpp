#include "generator/wcet/proven_bound.hpp"

#include "generator/wcet/certificate.hpp"

namespace finemote::gen::wcet {

std::optional<LongestPath> proven_path(const UnrolledGraph& graph) {
  auto path = longest_path(graph);
  if (path && !check_certificate(graph, path->potentials, path->bound).empty()) return std::nullopt;
  return path;
}

std::optional<Cycles> proven_bound(const UnrolledGraph& graph) {
  const auto path = proven_path(graph);
  return path ? std::optional(path->bound) : std::nullopt;
}

}  // namespace finemote::gen::wcet
