#include "qemu.hpp"

#include <sys/wait.h>

#include <cstdio>
#include <sstream>

namespace finemote::test {
namespace {

std::string command_for(const std::string& name) {
  return "timeout 60 " FINEMOTE_QEMU
         " -M netduinoplus2 -nographic -monitor none -serial none -chardev stdio,id=sh"
         " -semihosting-config enable=on,target=native,chardev=sh -icount shift=3,align=off,sleep=off"
         " -kernel " FINEMOTE_IMAGES "/" +
         name + ".elf </dev/null";
}

std::vector<StageEvent> events_in(const std::string& text) {
  std::vector<StageEvent> events;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string tag;
    StageEvent event{};
    char edge = 0;
    if (words >> tag >> event.ns >> event.stage >> edge && tag == "E") {
      event.end = edge == 'E';
      events.push_back(event);
    }
  }
  return events;
}

}  // namespace

Run run_on_qemu(const std::string& name) {
  Run run;
  FILE* pipe = popen(command_for(name).c_str(), "r");
  if (pipe == nullptr) return run;
  char chunk[4096];
  for (std::size_t n = 0; (n = fread(chunk, 1, sizeof chunk, pipe)) > 0;) run.text.append(chunk, n);
  const int status = pclose(pipe);
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.events = events_in(run.text);
  return run;
}

}  // namespace finemote::test
