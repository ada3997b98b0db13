#include "generator/simulate/lengths.hpp"

namespace finemote::gen {

Duration Lengths::draw(Duration least, Duration most) {
  if (--left_ <= 0) {
    manner_ = static_cast<Manner>(random_.between(0, 4));
    left_ = random_.between(1, 60);
  }
  switch (manner_) {
    case Manner::worst:
      return most;
    case Manner::best:
      return least;
    case Manner::uniform:
      return random_.between(least, most);
    case Manner::extreme:
      return random_.one_in(2) ? least : most;
    case Manner::mostly_worst:
      return random_.one_in(8) ? random_.between(least, most) : most;
  }
  return most;
}

}  // namespace finemote::gen
