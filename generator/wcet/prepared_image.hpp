// An image with all that is known of it before its routines are walked.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "generator/image/constants.hpp"
#include "generator/image/image.hpp"
#include "generator/image/program.hpp"
#include "generator/wcet/block_cost.hpp"
#include "generator/wcet/constants.hpp"
#include "generator/wcet/marks.hpp"
#include "generator/wcet/walk.hpp"

namespace finemote::gen::wcet {

class PreparedImage {
 public:
  /// @param image  outlives it
  /// @param marks  its own (read_marks), or others for a test
  PreparedImage(const Image& image, const KeptMembers& kept, CodeCost cost, Marks marks);
  PreparedImage(const PreparedImage&) = delete;
  PreparedImage& operator=(const PreparedImage&) = delete;

  /// From a routine's entry to its ends.
  [[nodiscard]] Walked walk_from(std::uint32_t entry) const { return walk_from(entry, marks_); }
  /// @param marks  at the same places as its own
  [[nodiscard]] Walked walk_from(std::uint32_t entry, const Marks& marks) const {
    return walk(context(constants_, nullptr, marks), entry);
  }

  [[nodiscard]] const Marks& marks() const { return marks_; }
  [[nodiscard]] const Program& program() const { return program_; }
  /// By address: words that start-up writes into members that are set there and never again.
  [[nodiscard]] const std::map<std::uint32_t, std::uint32_t>& words_at_start() const { return words_at_start_; }

 private:
  [[nodiscard]] WalkContext context(const Constants& constants, WordStores* stores, const Marks& marks) const;
  [[nodiscard]] std::map<std::uint32_t, std::uint32_t> words_set_at_start(const KeptMembers& kept) const;

  const Image& image_;
  const Marks marks_;
  const Program program_;
  const CodeCost cost_;
  const std::vector<AddressRange> members_;
  const std::map<std::uint32_t, std::uint32_t> words_at_start_;
  const Constants constants_;
};

}  // namespace finemote::gen::wcet
