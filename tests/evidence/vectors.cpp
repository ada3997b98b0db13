#include "tests/evidence/vectors.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/read.hpp"

namespace finemote::evidence {
namespace {

namespace fs = std::filesystem;

std::string text(const Json& object, const char* key) {
  return object.contains(key) && object.at(key).is_string() ? object.at(key).get<std::string>() : std::string();
}

unsigned number_in(const Json& value) {
  return value.is_string() ? number_of(value.get<std::string>()) : value.get<unsigned>();
}

std::vector<std::uint16_t> words_of(const Json& list) { return list.get<std::vector<std::uint16_t>>(); }

Exchange exchange_of(const Json& entry, std::vector<std::string>& unknown) {
  Exchange exchange;
  for (const auto& [key, value] : entry.items()) {
    if (key == "cs") {
      exchange.select = value.get<std::string>();
    } else if (key == "address") {
      exchange.address = number_in(value);
    } else if (key == "write") {
      exchange.written = bytes_of(value.get<std::string>());
    } else if (key == "read") {
      exchange.read = bytes_of(value.get<std::string>());
    } else if (key == "prom") {
      exchange.coefficients = words_of(value);
    } else if (key == "prom_words") {
      exchange.words = words_of(value);
    } else if (key == "d1") {
      exchange.pressure = value.get<std::uint32_t>();
    } else if (key == "d2") {
      exchange.temperature = value.get<std::uint32_t>();
    } else {
      unknown.push_back("transactions." + key);
    }
  }
  return exchange;
}

/// False: there is no such key.
bool take(Vector& vector, const std::string& key, const Json& value) {
  constexpr const char* kOthers[] = {"name", "origin", "source", "commit", "licence", "decoder", "note"};
  if (key == "bytes") {
    vector.bursts.push_back({0, bytes_of(value.get<std::string>())});
  } else if (key == "series") {
    for (const Json& burst : value)
      vector.bursts.push_back({burst.at(0).get<std::int64_t>(), bytes_of(burst.at(1).get<std::string>())});
  } else if (key == "transactions") {
    for (const Json& exchange : value) vector.exchanges.push_back(exchange_of(exchange, vector.unknown_keys));
  } else if (key == "can_id") {
    vector.can_id = number_in(value);
  } else if (key == "expected") {
    vector.expected = value;
  } else {
    return std::find(std::begin(kOthers), std::end(kOthers), key) != std::end(kOthers);
  }
  return true;
}

Vector vector_of(const std::string& protocol, const Json& entry) {
  Vector vector;
  vector.protocol = protocol;
  vector.name = text(entry, "name");
  vector.origin = text(entry, "origin");
  vector.source = text(entry, "source");
  vector.commit = text(entry, "commit");
  vector.licence = text(entry, "licence");
  for (const auto& [key, value] : entry.items()) {
    try {
      if (!take(vector, key, value)) vector.unknown_keys.push_back(key);
    } catch (const std::exception& error) {
      vector.unknown_keys.push_back(key + " (" + error.what() + ")");
    }
  }
  return vector;
}

unsigned digit_of(char digit) {
  if (digit >= '0' && digit <= '9') return static_cast<unsigned>(digit - '0');
  if (digit >= 'a' && digit <= 'f') return static_cast<unsigned>(digit - 'a' + 10);
  if (digit >= 'A' && digit <= 'F') return static_cast<unsigned>(digit - 'A' + 10);
  throw std::runtime_error(std::string("'") + digit + "' is no hexadecimal digit");
}

}  // namespace

Bytes Vector::bytes() const {
  Bytes all;
  for (const Burst& burst : bursts) all.insert(all.end(), burst.bytes.begin(), burst.bytes.end());
  return all;
}

Bytes bytes_of(const std::string& hexadecimal) {
  if (hexadecimal.size() % 2 != 0) throw std::runtime_error("half a byte in '" + hexadecimal + "'");
  Bytes bytes;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(digit_of(hexadecimal[i]) << 4 | digit_of(hexadecimal[i + 1])));
  return bytes;
}

std::string hexadecimal(const Bytes& bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

unsigned number_of(const std::string& hexadecimal) {
  const std::size_t from = hexadecimal.rfind("0x", 0) == 0 ? 2 : 0;
  unsigned number = 0;
  for (const char digit : hexadecimal.substr(from)) number = number << 4 | digit_of(digit);
  return number;
}

std::vector<Vector> read_vectors(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error("no folder " + folder.string());
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Vector> vectors;
  for (const fs::path& file : files) {
    try {
      for (const Json& entry : Json::parse(test::read(file))) vectors.push_back(vector_of(file.stem().string(), entry));
    } catch (const std::exception& error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  }
  return vectors;
}

}  // namespace finemote::evidence
