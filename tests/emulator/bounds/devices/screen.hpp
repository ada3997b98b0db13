// Sends a picture in one exchange, each job.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/spi.hpp"

namespace bounds {

class Screen {
 public:
  constexpr explicit Screen(finemote::SpiSlot& slot) : slot_(&slot) {}

  void update() {}
  void handle() {
    if (slot_->busy()) return;
    ++picture_[0];
    slot_->start(picture_, nullptr, sizeof picture_);
  }

  finemote::Stamp state;

 private:
  finemote::SpiSlot* slot_;
  std::uint8_t picture_[1024]{};
};

}  // namespace bounds
