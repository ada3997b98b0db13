#include "generator/file/system_reason.hpp"

#include <cctype>
#include <cstring>

namespace finemote::gen {

std::string system_reason(int error) {
  std::string words = std::strerror(error);
  if (!words.empty()) words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
  return words;
}

}  // namespace finemote::gen
