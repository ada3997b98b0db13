// Values over time to a small picture with axes.
#pragma once

#include <string>
#include <vector>

namespace finemote::gen::report {

struct Plot {
  struct Point {
    double x, y;
  };
  /// Where a value was wanted.
  struct Band {
    double x_from, x_to, y_from, y_to;
  };
  std::string title;                       ///< for screen readers: `base_link depth`
  std::string attributes = {};             ///< of the line: what it shows
  std::vector<Point> points = {};          ///< x in ns and rising
  std::vector<Band> bands = {};            ///< drawn as far as they are within the axes
  std::string limit_attributes = {};       ///< of the line at `limit`
  double limit = 0;                        ///< drawn dashed where it is positive; y begins at 0 then
  bool is_time = false;                    ///< y is in ns as well
  [[nodiscard]] bool is_constant() const;  ///< or has no points
};

/// `<svg>`; empty where there is nothing that could be drawn.
std::string drawn(const Plot& plot);

}  // namespace finemote::gen::report
