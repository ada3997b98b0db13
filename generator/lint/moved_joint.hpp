// Two links of a robot to the joint between them that a device turns.
#pragma once

#include <optional>
#include <string>

#include "generator/lint/rule.hpp"

namespace finemote::gen {

struct MovedJoint {
  const Joint* joint = nullptr;
  const Device* mover = nullptr;  ///< turns it, itself or by a joint it follows
};

/// The first on the way to `link`, else to `other`, from where the two ways part. None where every joint between them
/// stands still, or where a way does not end.
std::optional<MovedJoint> moved_between(const CheckedGeometry& checked, const std::string& link,
                                        const std::string& other);

}  // namespace finemote::gen
