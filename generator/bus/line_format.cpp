#include "generator/bus/line_format.hpp"

namespace finemote::gen {

LineFormat line_format(std::string_view text) {
  LineFormat format;
  format.has_even_parity = text.size() > 1 && text[1] == 'E';
  format.stop_bits = text.size() > 2 && text[2] == '2' ? 2 : 1;
  format.is_inverted = text.ends_with("_inverted");
  return format;
}

}  // namespace finemote::gen
