// The emulated core against QEMU: the same image, 8 ns an instruction on both, must give the same events.
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "emulator/board.hpp"

using namespace finemote::emulator;

namespace {

struct Event {
  long long t_ns;
  unsigned stage;
  char edge;
};

std::string run_qemu(const std::string& image) {
  const std::string command = std::string("timeout 60 ") + FINEMOTE_QEMU +
                              " -M netduinoplus2 -nographic -monitor none -serial none -chardev stdio,id=sh"
                              " -semihosting-config enable=on,target=native,chardev=sh"
                              " -icount shift=3,align=off,sleep=off -kernel " +
                              image + " </dev/null";
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, n);
  REQUIRE(pclose(pipe) == 0);
  return output;
}

std::vector<Event> events_of(const std::string& text) {
  std::vector<Event> events;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    Event event{};
    if (std::sscanf(line.c_str(), "E %lld %u %c", &event.t_ns, &event.stage, &event.edge) == 3) events.push_back(event);
  }
  return events;
}

}  // namespace

TEST_CASE("in QEMU-cost mode the events are QEMU's, in order and to one count of the release timer") {
  const std::string path = std::string(FINEMOTE_QEMU_IMAGES) + "/sample.elf";
  BoardOptions options;
  options.cost = CostModel::qemu;
  options.probe = false;
  Board board(options);
  board.load(load_image(path));
  REQUIRE(board.run_for(1'000'000'000) == Stop::exit);
  CHECK(board.cpu().exit_code() == 0);
  const auto ours = events_of(board.cpu().console()), theirs = events_of(run_qemu(path));
  REQUIRE(theirs.size() > 100);
  REQUIRE(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    INFO("event " << i);
    REQUIRE(ours[i].stage == theirs[i].stage);
    REQUIRE(ours[i].edge == theirs[i].edge);
    REQUIRE(std::llabs(ours[i].t_ns - theirs[i].t_ns) <= 6);  // 168 MHz: 5.95 ns
  }
}
