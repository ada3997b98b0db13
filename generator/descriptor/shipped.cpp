#include "generator/descriptor/shipped.hpp"

#include <algorithm>

#include "generator/descriptor/digest.hpp"
#include "generator/descriptor/shipped_digests.hpp"

namespace finemote::gen {

bool is_shipped(std::string_view text) {
  return std::binary_search(std::begin(kShippedDigests), std::end(kShippedDigests), digest(text));
}

}  // namespace finemote::gen
