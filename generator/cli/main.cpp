// finemote: from a robot description to firmware.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#ifdef __GLIBC__  // known once a header of the library was read
#include <malloc.h>
#endif

#include "generator/cli/answer.hpp"
#include "generator/cli/command_line.hpp"
#include "generator/cli/commands.hpp"
#include "generator/cli/sandbox.hpp"
#include "generator/cli/settings.hpp"
#include "generator/cli/watch.hpp"
#include "generator/diagnostic/render.hpp"
#include "generator/file/descriptor_buffer.hpp"
#include "generator/file/installed_file.hpp"
#include "generator/file/system_reason.hpp"
#include "generator/run/process.hpp"

namespace {

using namespace finemote::gen;

/// The command's answer, with what finemote.json beside a robot sets.
Answer answer_of(const Options& options, Sources& sources, Diagnostics& diagnostics) {
  const Command& command = command_named(options.command);
  if (!has_option(command, "--show-config")) return command.run(options, sources, diagnostics);
  const Settings settings = settings_of(options, sources, diagnostics);
  if (diagnostics.has_errors()) return no_answer();
  if (options.show_config) return settings_answer(settings);
  return command.run(settings.options, sources, diagnostics);
}

/// Runs the command and prints its answer; `read`, where it is given, gets what the answer depends on.
int run(const Options& options, std::ostream& out, std::vector<std::string>* read = nullptr) {
  Diagnostics diagnostics;
  Sources sources(read_access(options, diagnostics));
  if (diagnostics.has_errors()) return finish(options, no_answer(), diagnostics, out, std::cerr);
  if (!options.sandbox) {
    Answer answer = answer_of(options, sources, diagnostics);
    if (read != nullptr) *read = watched_paths(options, sources);
    return finish(options, std::move(answer), diagnostics, out, std::cerr);
  }
  bound_resources();
  try {
    return finish(options, answer_of(options, sources, diagnostics), diagnostics, out, std::cerr);
  } catch (const std::bad_alloc&) {
    report_memory_limit(diagnostics);
    return finish(options, no_answer(), diagnostics, out, std::cerr);
  }
}

/// Answers again and again, until a signal ends the program.
[[noreturn]] void run_and_watch(const Options& options, std::ostream& out) {
  std::vector<std::string> paths = watched_paths(options, Sources());
  while (true) {
    Watched watched(paths);  // what changes while the command runs counts, too
    std::vector<std::string> read;
    run(options, out, &read);
    if (read != paths) watched = Watched(paths = read);
    if (!options.quiet) std::cerr << "watching; Ctrl-C ends\n" << std::flush;
    watched.wait();
  }
}

/// The tool lives for milliseconds: memory comes from the system in few large pieces, one pool for all threads.
void prepare_memory() {
#ifdef __GLIBC__
  constexpr int piece = 8 << 20;
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, piece);
#endif
}

/// A stream that is closed stays so: no file that is opened may get its number, and be written to by mistake.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    const int wrong_way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (open("/dev/null", wrong_way) < 0) return;
  }
}

int report(Code code, const std::string& message, const char* hint, int status) {
  Diagnostics diagnostics;
  Diagnostic& finding = diagnostics.error(code, {}, message);
  if (hint != nullptr) finding.hint(hint);
  std::cerr << render_text(diagnostics, false);
  return status;
}

int run_words(const std::vector<std::string>& words, std::ostream& out) {
  try {
    const ParsedCommandLine parsed = parse_command_line(words);
    if (parsed.options && parsed.options->watch) {
      if (parsed.options->input == "-")
        return report(code::usage, "--watch cannot watch standard input", "give the name of the file", kExitInvalid);
      run_and_watch(*parsed.options, out);
    }
    if (parsed.options) return run(*parsed.options, out);
    (parsed.exit_status == kExitYes ? out : std::cerr) << parsed.text;
    out << parsed.findings;
    return parsed.exit_status;
  } catch (const std::filesystem::filesystem_error& error) {
    return report(code::unreadable_file,
                  "cannot use '" + error.path1().generic_string() + "': " + system_reason(error.code().value()),
                  nullptr, kExitInvalid);
  } catch (const DamagedInstallation& error) {
    return report(code::data_not_found, error.what(), kInstallAgain, kExitInvalid);
  } catch (const std::exception& error) {
    return report(code::internal, std::string("internal error: ") + error.what(),
                  "this is a defect of finemote; please report it with the input that shows it", kExitInternal);
  }
}

/// Ends as whoever asked for it expects, now that nothing is left behind.
[[noreturn]] void stop_as_asked(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  std::exit(kExitInternal);
}

}  // namespace

int main(int argc, char** argv) {
  prepare_memory();
  occupy_standard_streams();
  std::ios::sync_with_stdio(false);
  DescriptorBuffer standard_output(STDOUT_FILENO);
  std::ostream out(&standard_output);
  std::cerr.tie(&out);  // what was said first comes first, where both go to one place
  int status = kExitInternal;
  try {
    status = run_words(std::vector<std::string>(argv + 1, argv + argc), out);
  } catch (const StopRequested& stop) {
    stop_as_asked(stop.signal);
  }
  out.flush();
  if (standard_output.error() == 0) return status;
  // Whoever reads the result would take what is there for all of it.
  return report(code::output_not_writable, "cannot write to standard output: " + system_reason(standard_output.error()),
                nullptr, kExitInvalid);
}
