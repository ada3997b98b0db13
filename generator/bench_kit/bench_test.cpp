#include "generator/bench_kit/bench_test.hpp"

namespace finemote::gen {

const char* ground_words(Ground ground) {
  switch (ground) {
    case Ground::data_sheet:
      return "data sheet";
    case Ground::manual:
      return "manual";
    case Ground::board_file:
      return "board file";
    case Ground::measured:
      return "measured, emulated";
    case Ground::declared:
      return "declared";
    case Ground::assumed:
      break;
  }
  return "assumed";
}

}  // namespace finemote::gen
