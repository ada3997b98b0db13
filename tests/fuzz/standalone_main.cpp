// Drives a fuzz target without libFuzzer: the corpus, then inputs mutated from it with a fixed seed.
//
//   TARGET [-runs=N] [-seed=N] FOLDER
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// What a target knows about changing its inputs; not every target has one.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t most, unsigned int seed);
/// A custom mutator may leave an input to the plain one; here it was changed already.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* /*data*/, std::size_t size, std::size_t /*most*/) { return size; }

namespace {

using Random = std::mt19937_64;

void feed(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<std::string> read_corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

std::size_t below(Random& random, std::size_t limit) { return limit == 0 ? 0 : random() % limit; }

/// One change: a byte, a deleted or repeated stretch, or a stretch of another input.
void mutate(std::string& text, const std::vector<std::string>& corpus, Random& random) {
  const std::size_t at = below(random, text.size() + 1);
  const std::size_t length = below(random, 12);
  const std::string& other = corpus[below(random, corpus.size())];
  const std::size_t from = below(random, other.size() + 1);
  constexpr std::string_view marks = "<>/\"'${}()[]=.,:*%+-^|&;!#\\\n 019aexX_";
  switch (below(random, 5)) {
    case 0:
      text.insert(at, 1, marks[below(random, marks.size())]);
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(at, length));
      break;
    case 3:
      text.insert(at, other.substr(from, length * 4));
      break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(random());
  }
}

void mutate_as_target(std::string& text, Random& random) {
  const std::size_t size = text.size();
  const std::size_t most = 2 * size + 4096;
  text.resize(most);
  text.resize(LLVMFuzzerCustomMutator(reinterpret_cast<std::uint8_t*>(text.data()), size, most,
                                      static_cast<unsigned int>(random())));
}

std::uint64_t option(std::string_view word, std::string_view name, std::uint64_t otherwise) {
  return word.starts_with(name) ? std::strtoull(word.data() + name.size(), nullptr, 10) : otherwise;
}

}  // namespace

int main(int count, char** words) {
  std::uint64_t runs = 2000;
  std::uint64_t seed = 1;
  std::string folder;
  for (int i = 1; i < count; ++i) {
    runs = option(words[i], "-runs=", runs);
    seed = option(words[i], "-seed=", seed);
    if (words[i][0] != '-') folder = words[i];
  }
  const auto corpus = read_corpus(folder);
  for (const std::string& input : corpus) feed(input);
  Random random(seed);
  for (std::uint64_t run = 0; run < runs; ++run) {
    std::string input = corpus[below(random, corpus.size())];
    const bool as_target = LLVMFuzzerCustomMutator != nullptr && below(random, 8) > 0;
    const std::size_t changes = 1 + below(random, as_target ? 2 : 6);
    for (std::size_t i = 0; i < changes; ++i)
      as_target ? mutate_as_target(input, random) : mutate(input, corpus, random);
    std::ofstream("fuzz-last-input", std::ios::binary) << input;  // what to look at after a crash
    feed(input);
  }
  std::filesystem::remove("fuzz-last-input");
  std::cout << corpus.size() << " inputs of the corpus and " << runs << " mutated ones\n";
  return 0;
}
