#include "generator/run/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace finemote::gen {
namespace {

constexpr std::size_t kMostOutput = std::size_t{256} << 20;

/// While it lives, signals that ask this process to stop are kept and can be polled for.
class StopRequests {
 public:
  StopRequests() {
    sigset_t asked;
    sigemptyset(&asked);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction action {};
      sigaction(signal, nullptr, &action);
      if (action.sa_handler != SIG_IGN) sigaddset(&asked, signal);  // blocked, it would come in spite of that
    }
    sigprocmask(SIG_BLOCK, &asked, &before_);
    file_ = signalfd(-1, &asked, SFD_CLOEXEC);
    if (file_ < 0) let_through();
  }
  ~StopRequests() {
    close(file_);
    let_through();
  }
  StopRequests(const StopRequests&) = delete;
  StopRequests& operator=(const StopRequests&) = delete;

  /// As they were before: what a new program starts with.
  void let_through() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  [[nodiscard]] int file() const { return file_; }  ///< readable when there is one; -1: they cannot be polled for
  /// The one that was asked for.
  [[nodiscard]] int signal() const {
    signalfd_siginfo info{};
    return read(file_, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : SIGTERM;
  }

 private:
  sigset_t before_{};
  int file_ = -1;
};

/// @param failed  where a byte is written if there is no such program; closed as another one starts
[[noreturn]] void become(std::vector<std::string> command, const std::vector<std::string>& environment, int out,
                         int failed) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // where this process has no time to end it: SIGKILL
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  for (const std::string& entry : environment) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos) {
      unsetenv(entry.c_str());
      continue;
    }
    setenv(entry.substr(0, equals).c_str(), entry.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(write(failed, "", 1) == 1 ? EXIT_FAILURE : EXIT_SUCCESS);
}

using SteadyClock = std::chrono::steady_clock;

/// At least 0, at most what poll() takes [ms].
int milliseconds_until(SteadyClock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - SteadyClock::now()).count();
  return static_cast<int>(std::clamp<std::int64_t>(left, 0, INT_MAX));
}

enum class End : std::uint8_t { by_itself, timed_out, stopped };

/// Collects output until the pipe closes, the time is over, or this process is asked to stop.
End collect(int pipe, int stop, SteadyClock::time_point end, std::string& output) {
  std::array<char, 65536> chunk{};
  for (;;) {
    const int left = milliseconds_until(end);
    if (left == 0) return End::timed_out;
    std::array<pollfd, 2> wait{{{pipe, POLLIN, 0}, {stop, POLLIN, 0}}};
    const int ready = poll(wait.data(), wait.size(), left);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return End::timed_out;
    if (wait[1].revents != 0) return End::stopped;
    const ssize_t count = read(pipe, chunk.data(), chunk.size());
    if (count <= 0) return End::by_itself;
    if (output.size() < kMostOutput) output.append(chunk.data(), static_cast<std::size_t>(count));
  }
}

/// Waits until the child has ended, the time is over, or this process is asked to stop: a child may close its output
/// long before it ends.
End await(pid_t child, int stop, SteadyClock::time_point end, int& status) {
  constexpr int kLongestPause = 50;  // ms
  for (int pause = 1;; pause = std::min(2 * pause, kLongestPause)) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) return End::by_itself;
    const int left = milliseconds_until(end);
    if (left == 0) return End::timed_out;
    pollfd wait{stop, POLLIN, 0};
    if (poll(&wait, 1, std::min(pause, left)) > 0) return End::stopped;
  }
}

/// The exit status of a child that is killed with all of its group.
int killed(pid_t child) {
  int status = 0;
  kill(-child, SIGKILL);
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  return status;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, std::chrono::seconds limit,
                          const std::vector<std::string>& environment) {
  std::array<int, 2> pipes{}, failures{};
  if (pipe2(pipes.data(), O_CLOEXEC) != 0 || pipe2(failures.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("cannot make a pipe");
  const StopRequests stop;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) {
    stop.let_through();
    become(command, environment, pipes[1], failures[1]);
  }
  setpgid(child, child);  // whoever of the two comes first: from here on the group can be killed
  close(pipes[1]);
  close(failures[1]);

  ProcessResult result;
  int status = 0;
  const SteadyClock::time_point latest = SteadyClock::now() + limit;
  End end = collect(pipes[0], stop.file(), latest, result.output);
  if (end == End::by_itself) end = await(child, stop.file(), latest, status);
  if (end != End::by_itself) status = killed(child);
  char failure = 0;
  result.started = read(failures[0], &failure, 1) == 0;
  close(pipes[0]);
  close(failures[0]);
  if (end == End::stopped) throw StopRequested{stop.signal()};
  result.timed_out = end == End::timed_out;
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

void report_not_started(const std::string& program, const std::string& hint, Diagnostics& diagnostics) {
  diagnostics.error(code::missing_tool, {}, fmt::format("cannot start '{}'", program)).hint(hint);
}

}  // namespace finemote::gen
