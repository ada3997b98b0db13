// Work of which every job takes another time: a job that ends early lets others meet that do not otherwise.
#pragma once

#include <cstdint>

#include "finemote/contract.hpp"
#include "finemote/interfaces/any.hpp"

namespace campaign {

class Restless {
 public:
  struct Config {
    finemote::Duration update = 10 * finemote::kMicrosecond;  ///< how long update() works at most
    finemote::Duration handle = 10 * finemote::kMicrosecond;  ///< how long handle() works at most
    std::int32_t seed = 1;
  };

  constexpr explicit Restless(const Config& config)
      : config_(config), random_(static_cast<std::uint32_t>(config.seed) * 2654435761U | 1U) {}

  void update() {
    state = {finemote::now(), true};
    work(config_.update);
  }
  void handle() { work(config_.handle); }

  finemote::Stamp state;
  finemote::Stamp command;

 private:
  /// The full time, or a part in 256 parts of it.
  void work(finemote::Duration most) {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    random_ ^= random_ << 5;
    const bool is_full = (random_ & 0x10000U) != 0;
    const auto part = static_cast<std::int64_t>(random_ >> 24);
    const finemote::Duration time = is_full ? most : most * part / 256;
    if (time != 0) finemote::busy(time);
  }

  const Config config_;
  std::uint32_t random_;
};

}  // namespace campaign
