// Other programs: what they say, when they take too long, and what becomes of them when this one is told to stop.
#include "generator/run/process.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "catch.hpp"

using namespace finemote::gen;
using namespace std::chrono_literals;

namespace {

/// The process that a shell wrote its number of into this file; 0: not yet.
pid_t process_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  pid_t process = 0;
  in >> process;
  return in ? process : 0;
}

/// Also where nobody has taken note of it yet.
bool has_ended(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return text.empty() || text.find(") Z") != std::string::npos;
}

template <class Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(10ms);
  return condition();
}

}  // namespace

TEST_CASE("what a program says, and how it ends") {
  const ProcessResult result = run_process({"sh", "-c", "echo one; echo two >&2; exit 3"}, 60s);
  CHECK(result.started);
  CHECK(result.exit_status == 3);
  CHECK(result.output == "one\ntwo\n");
  CHECK_FALSE(run_process({"no-such-program"}, 60s).started);
  CHECK(run_process({"sleep", "1000"}, 0s).timed_out);
}

TEST_CASE("a program that closes its output has still to end in time") {
  CHECK(run_process({"sh", "-c", "exec >/dev/null 2>&1; exec sleep 1000"}, 1s).timed_out);
  CHECK(run_process({"sh", "-c", "exec >/dev/null 2>&1; sleep 0.1; exit 4"}, 60s).exit_status == 4);
}

TEST_CASE("a status of 127 is an answer of a program that was there") {
  const ProcessResult result = run_process({"sh", "-c", "exit 127"}, 60s);
  CHECK(result.started);
  CHECK(result.exit_status == 127);
}

TEST_CASE("who is told to stop while a program runs ends that one first") {
  const auto file = std::filesystem::temp_directory_path() / ("finemote-process-test-" + std::to_string(getpid()));
  const int signal = GENERATE(SIGTERM, SIGINT, SIGHUP, SIGKILL);
  std::filesystem::remove(file);
  const pid_t child = fork();
  if (child == 0) {
    if (signal != SIGKILL) std::signal(signal, SIG_DFL);
    try {
      run_process({"sh", "-c", "echo $$ >" + file.string() + "; exec sleep 1000"}, 900s);
    } catch (const StopRequested& stop) {
      _exit(stop.signal);
    }
    _exit(0);
  }
  REQUIRE(comes_true([&] { return process_in(file) != 0; }));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status) == (signal == SIGKILL));  // told so, it ends by itself
  CHECK((WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status)) == signal);
  CHECK(comes_true([&] { return has_ended(process_in(file)); }));
  std::filesystem::remove(file);
}

TEST_CASE("a signal that is ignored stops nothing") {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const ProcessResult result = run_process({"sh", "-c", "kill -HUP " + std::to_string(getpid()) + "; echo done"}, 60s);
  std::signal(SIGHUP, before);
  CHECK(result.output == "done\n");
}
