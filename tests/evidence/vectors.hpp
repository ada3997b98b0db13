// Turns a folder of frames recorded or published by others into vectors, one file per protocol.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace finemote::evidence {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;

/// Bytes that follow each other without a gap.
struct Burst {
  std::int64_t at = 0;  ///< ns, when the first byte begins
  Bytes bytes;
};

/// One exchange on an I2C or SPI bus; of a pressure sensor also what its memory or its converter holds.
struct Exchange {
  std::string select;               ///< SPI: "accel" or "gyro"; empty: I2C
  std::optional<unsigned> address;  ///< I2C; empty: the part's usual one
  Bytes written, read;
  std::vector<std::uint16_t> coefficients;             ///< C1..C6
  std::vector<std::uint16_t> words;                    ///< all seven, with the checksum in the first
  std::optional<std::uint32_t> pressure, temperature;  ///< D1 and D2, the converter's results
};

/// Bytes of others, and what they say the bytes mean.
struct Vector {
  std::string protocol, name;
  std::string origin, source, commit, licence;
  std::vector<Burst> bursts;        ///< one at 0 where the file has `bytes`
  std::vector<Exchange> exchanges;  ///< where the file has `transactions`
  std::optional<unsigned> can_id;
  Json expected = Json::object();
  std::vector<std::string> unknown_keys;  ///< what the format does not have, or not like that

  /// All bytes of all bursts.
  [[nodiscard]] Bytes bytes() const;
};

/// The vectors of every *.json of a folder, by file and in the order of the file.
/// @throws std::runtime_error  no such folder, or no JSON
std::vector<Vector> read_vectors(const std::filesystem::path& folder);

/// @throws std::runtime_error
Bytes bytes_of(const std::string& hexadecimal);
std::string hexadecimal(const Bytes& bytes);
/// "0x141" or "141".
unsigned number_of(const std::string& hexadecimal);

}  // namespace finemote::evidence
