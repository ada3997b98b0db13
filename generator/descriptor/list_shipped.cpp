// list_shipped HEADER FILE...: writes shipped_digests.hpp, the digests of the files, rising. The build runs it.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

#include "generator/descriptor/digest.hpp"

int main(int count, char** words) {
  std::vector<std::uint64_t> digests;
  for (int i = 2; i < count; ++i) {
    std::ifstream in(words[i], std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) return std::cerr << "cannot read " << words[i] << '\n', 1;
    digests.push_back(finemote::gen::digest(text.str()));
  }
  if (digests.empty()) return std::cerr << "list_shipped HEADER FILE...\n", 1;
  std::sort(digests.begin(), digests.end());
  std::ofstream out(words[1]);
  out << "// The digests of all descriptors, board and chip files that are shipped, rising.\n"
         "#pragma once\n\n#include <cstdint>\n\nnamespace finemote::gen {\n\n"
         "inline constexpr std::uint64_t kShippedDigests[] = {\n";
  for (const std::uint64_t digest : digests) out << "    " << digest << "U,\n";
  out << "};\n\n}  // namespace finemote::gen\n";
  return out.flush() ? 0 : 1;
}
