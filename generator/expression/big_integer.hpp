// The representation of integers beyond 64 bits; included only where such are computed, because it is slow to compile.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "generator/expression/integer.hpp"

namespace finemote::gen::expression {

using BigInteger = boost::multiprecision::cpp_int;

struct BigHolder {
  BigInteger value;
};

/// The value in the representation without bound.
BigInteger big_of(const Integer& i);

/// The integer, in the small representation where it fits.
Integer integer_from(BigInteger value);

}  // namespace finemote::gen::expression
