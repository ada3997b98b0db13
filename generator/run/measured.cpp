#include "generator/run/measured.hpp"

namespace finemote::gen {

std::string_view judgement_name(Judgement judgement) {
  switch (judgement) {
    case Judgement::held:
      return "held";
    case Judgement::broken:
      return "broken";
    case Judgement::no_sample:
      return "no-sample";
    case Judgement::no_bound:
      return "no-bound";
  }
  return "";
}

}  // namespace finemote::gen
