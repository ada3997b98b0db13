#include "generator/run/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>

namespace finemote::gen {
namespace {

constexpr std::size_t kMostOutput = std::size_t{256} << 20;
constexpr int kNoSuchProgram = 127;

[[noreturn]] void become(std::vector<std::string> command, const std::vector<std::string>& environment, int out) {
  setpgid(0, 0);
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
  _exit(kNoSuchProgram);
}

/// Collects output until the pipe closes; false when the time is over.
bool collect(int pipe, std::chrono::steady_clock::time_point end, std::string& output) {
  std::array<char, 65536> chunk{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    pollfd wait{pipe, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t count = read(pipe, chunk.data(), chunk.size());
    if (count <= 0) return true;
    if (output.size() < kMostOutput) output.append(chunk.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, std::chrono::seconds limit,
                          const std::vector<std::string>& environment) {
  std::array<int, 2> pipes{};
  if (pipe2(pipes.data(), O_CLOEXEC) != 0) throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) become(command, environment, pipes[1]);
  close(pipes[1]);

  ProcessResult result;
  result.timed_out = !collect(pipes[0], std::chrono::steady_clock::now() + limit, result.output);
  if (result.timed_out) kill(-child, SIGKILL);
  close(pipes[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  result.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.started = result.exit_status != kNoSuchProgram;
  return result;
}

void report_not_started(const std::string& program, const std::string& hint, Diagnostics& diagnostics) {
  diagnostics.error(code::missing_tool, {}, fmt::format("cannot start '{}'", program)).hint(hint);
}

}  // namespace finemote::gen
