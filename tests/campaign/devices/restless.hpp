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
  void work(finemote::Duration most) {
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    random_ ^= random_ << 5;
    const finemote::Duration time = drawn(most);
    if (time != 0) finemote::busy(time);
  }

  /// In half of the cases all of it, else a part, or what ends just before others may be released.
  [[nodiscard]] finemote::Duration drawn(finemote::Duration most) const {
    const auto part = static_cast<std::int64_t>(random_ >> 24);
    switch (random_ >> 16 & 7U) {
      case 0:
        return until_release(most);
      case 1:
        return until_release(most * part / 256);
      case 2:
      case 3:
        return most * part / 256;
      default:
        return most;
    }
  }

  /// At most this long, and then it is up to 102 us to the next instant of releases: what runs next is there when
  /// others are released. Right in the first four seconds.
  [[nodiscard]] finemote::Duration until_release(finemote::Duration most) const {
    constexpr std::uint32_t kBetweenReleases = 500'000, kStep = 400;  // ns
    const auto at = static_cast<std::uint32_t>(finemote::now());
    const std::uint32_t ahead = (random_ >> 8 & 0xFFU) * kStep;
    const std::uint32_t surplus = (at + static_cast<std::uint32_t>(most) + ahead) % kBetweenReleases;
    return surplus < most ? most - surplus : most;
  }

  const Config config_;
  std::uint32_t random_;
};

}  // namespace campaign
