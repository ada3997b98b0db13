// Exchanges the most bytes that the port copies, from memory that DMA does not reach, whenever it may.
#pragma once

#include <finemote/contract.hpp>
#include <finemote/spi.hpp>

namespace testing {

class Exchange {
 public:
  constexpr explicit Exchange(finemote::SpiSlot& slot) : slot_(&slot) {}

  void update() {
    if (!slot_->busy()) slot_->start(sent_, received_, sizeof sent_);
  }
  void handle() {}

  finemote::Stamp state;

 private:
  finemote::SpiSlot* const slot_;
  std::uint8_t sent_[64]{}, received_[64]{};
};

}  // namespace testing
