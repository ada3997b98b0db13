// The ways that the static analysis allows each routine of an image, ready to be followed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "generator/wcet/image_times.hpp"
#include "generator/wcet/prepared_image.hpp"

namespace finemote::test {

/// A node after another one.
struct Onward {
  std::size_t to = 0;
  gen::wcet::Cycles cost = 0;
};

struct Routine {
  unsigned exception = 0;
  gen::wcet::Walked walked;
  gen::wcet::Cycles bound = 0;
  std::map<std::uint32_t, gen::wcet::Cycles> brackets;  ///< bounds by the begin mark
  std::vector<std::vector<Onward>> onward;              ///< by node
  std::vector<bool> is_exit;                            ///< by node

  /// The node after `node` that begins at this address.
  [[nodiscard]] std::optional<Onward> behind(std::size_t node, std::uint32_t address) const;
};

/// An ELF file, and what debug information says of it.
struct LoadedImage {
  explicit LoadedImage(const std::string& path);

  gen::Image image;
  gen::KeptMembers kept;
  gen::wcet::Marks marks;
  gen::wcet::Placement placement;
};

struct Routes {
  /// @param loaded, costs  outlive it
  Routes(const LoadedImage& loaded, const gen::wcet::CostTable& costs, gen::wcet::Marks marks);

  const LoadedImage& loaded;
  const gen::wcet::CodeCost cost;
  const gen::wcet::PreparedImage prepared;
  std::map<unsigned, Routine> routines;  ///< by exception
  std::vector<std::string> problems;     ///< why some have no bound

  [[nodiscard]] std::vector<std::uint32_t> borders() const;
};

}  // namespace finemote::test
