// emulator_speed IMAGE PARTS SECONDS: runs an image with its parts (`finemote run --keep` leaves both), and prints how
// fast.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>

#include "emulator/outfit/outfit.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

void measure(const char* image, const char* parts, double seconds) {
  Board board{finemote::test::type_c()};
  Outfit outfit(board);
  board.load(load_image(image));
  std::ifstream file(parts);
  outfit.add(Json::parse(file));
  board.run_for(200'000'000);  // bring-up of clocks and parts
  const std::uint64_t instructions = board.cpu().executed();
  const Time idle = board.cpu().idle_time();
  const std::clock_t begin = std::clock();
  board.run_for(static_cast<std::uint64_t>(seconds * 1e9));
  const double spent = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const auto count = static_cast<double>(board.cpu().executed() - instructions);
  const double idled = static_cast<double>(to_ns(board.cpu().idle_time() - idle)) * 1e-9;
  std::printf("%.1f s of the board in %.2f s of processor time (%.2f x real time): %.1f M instructions, idle %.1f %%\n",
              seconds, spent, seconds / spent, count / 1e6, 100 * idled / seconds);
  std::printf("%.1f M instructions a second of processor time; with those it was idle for, %.0f M cycles a second\n",
              count / spent / 1e6, 168 * seconds / spent);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return std::fprintf(stderr, "usage: emulator_speed IMAGE PARTS SECONDS\n"), 2;
  try {
    measure(argv[1], argv[2], std::atof(argv[3]));
    return 0;
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
