// Something that makes a tone.
#pragma once

#include "finemote/contract.hpp"

namespace finemote {

/// What it does.
struct SounderState : Stamp {
  float frequency = 0;  ///< of the tone it makes [Hz]; 0: silent
};

/// What it should do.
struct SounderCommand : Stamp {
  float frequency = 0;  ///< Hz; 0: silence
  float volume = 1;     ///< 0..1
};

/// Offered by buzzers.
struct Sounder {
  using State = SounderState;
  using Command = SounderCommand;
};

}  // namespace finemote
