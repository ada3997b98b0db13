// From a vector to what our driver and our part model make of it, one function per family of parts.
#pragma once

#include "tests/evidence/findings.hpp"
#include "tests/evidence/vectors.hpp"

namespace finemote::evidence {

using Decoder = Findings (*)(const Vector& vector);

Findings decode_c610(const Vector& vector);
Findings decode_m3508(const Vector& vector);
Findings decode_gm6020(const Vector& vector);
Findings decode_bmi088(const Vector& vector);
Findings decode_ist8310(const Vector& vector);
Findings decode_ms5837(const Vector& vector);
Findings decode_pca9685(const Vector& vector);
Findings decode_sbus(const Vector& vector);
Findings decode_dr16(const Vector& vector);
Findings decode_h30(const Vector& vector);

}  // namespace finemote::evidence
