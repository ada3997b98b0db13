// The emulated core against QEMU: the same image, 8 ns an instruction on both, must give the same events.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "emulator/board.hpp"
#include "tests/emulator/type_c.hpp"

using namespace finemote::emulator;

namespace {

struct Event {
  long long t_ns;
  unsigned stage;
  char edge;
};

/// What the image says; `counts` gets the number of its instructions.
std::string run_qemu(const std::string& image, const std::string& counts) {
  const std::string command = std::string("timeout 60 ") + FINEMOTE_QEMU +
                              " -M netduinoplus2 -nographic -monitor none -serial none -chardev stdio,id=sh"
                              " -semihosting-config enable=on,target=native,chardev=sh"
                              " -icount shift=3,align=off,sleep=off -plugin " FINEMOTE_COUNTER ",out=" +
                              counts + " -kernel " + image + " </dev/null";
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, n);
  REQUIRE(pclose(pipe) == 0);
  return output;
}

std::uint64_t total_of(const std::string& counts) {
  std::ifstream file(counts);
  std::uint64_t count = 0;
  for (std::string name; file >> count >> name;) {
    if (name == "total") return count;
  }
  return 0;
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

/// The image here and on QEMU: the same events, and as many instructions until it ends itself.
void compare(const std::string& name) {
  INFO(name);
  const std::string path = std::string(FINEMOTE_QEMU_IMAGES) + "/" + name + ".elf";
  BoardOptions options;
  options.cost = CostModel::qemu;
  options.probe = false;
  Board board{finemote::test::type_c(), options};
  board.load(load_image(path));
  REQUIRE(board.run_for(1'000'000'000) == Stop::exit);
  CHECK(board.cpu().exit_code() == 0);
  const std::string counts = path + ".counts";
  const auto ours = events_of(board.cpu().console()), theirs = events_of(run_qemu(path, counts));
  REQUIRE(theirs.size() > 50);
  REQUIRE(ours.size() == theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    INFO("event " << i << " at " << ours[i].t_ns << " and " << theirs[i].t_ns << " ns");
    REQUIRE(ours[i].stage == theirs[i].stage);
    REQUIRE(ours[i].edge == theirs[i].edge);
    REQUIRE(std::llabs(ours[i].t_ns - theirs[i].t_ns) <= 6);  // 168 MHz: 5.95 ns
  }
  // Asked to end, QEMU runs the instructions it has translated together with the request: three in these images.
  const std::uint64_t theirs_in_all = total_of(counts);
  CHECK(theirs_in_all >= board.cpu().instructions());
  CHECK(theirs_in_all <= board.cpu().instructions() + 3);
}

}  // namespace

TEST_CASE("in QEMU-cost mode the events are QEMU's, in order and to one count of the release timer") {
  compare("sample");
}

TEST_CASE("the images of examples run on QEMU as here, event by event and instruction by instruction") {
  compare("robot_two_devices");
  compare("robot_finsrov");
  compare("robot_infantry");
}
