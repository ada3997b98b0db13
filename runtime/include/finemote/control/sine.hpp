// Sine and cosine that always take the same time, or nearly.
#pragma once

namespace finemote {

/// Sine of a finite angle [rad]: within 5e-7 for -pi..pi, beyond it of what wrap_angle() makes of it. The library's
/// would reduce large angles by loops without a useful bound. Context: any bucket.
float sine(float angle);
/// Cosine, as sine().
float cosine(float angle);

}  // namespace finemote
