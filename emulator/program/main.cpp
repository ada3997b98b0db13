// finemote-emulator JOB RECORD: runs the job in the file JOB and writes what the board did to the file RECORD.
// finemote-emulator --image FILE [...]: runs any image for the chip and tells what its pins, buses and parts did.
//
// A program of its own, so that whatever an image makes of the board cannot take the tool along; `finemote run` starts
// it.
#include <malloc.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "emulator/program/job.hpp"
#include "emulator/program/watch.hpp"
#include "emulator/program/words.hpp"

namespace {

using Words = std::vector<std::string>;

void run_job(const std::string& job_file, const std::string& record_file) {
  std::ifstream job(job_file);
  if (!job) throw std::runtime_error("cannot read '" + job_file + "'");
  const auto record = finemote::emulator::run_job(nlohmann::ordered_json::parse(job));
  std::ofstream file(record_file, std::ios::binary | std::ios::trunc);
  file << record << "\n";
  file.close();
  if (!file) throw std::runtime_error("cannot write '" + record_file + "'");
}

/// Records are tens of megabytes of small pieces: taken from the system in large ones, and given back at the end alone.
void take_memory_in_large_pieces() {
  constexpr int kPiece = 32 << 20, kNever = 1 << 30;
  mallopt(M_TOP_PAD, kPiece);
  mallopt(M_TRIM_THRESHOLD, kNever);
  mallopt(M_MMAP_THRESHOLD, kNever);
}

int run(const Words& words) {
  if (words.size() == 2 && words[0].compare(0, 2, "--") != 0) {
    run_job(words[0], words[1]);
    return 0;
  }
  if (words == Words{"--help"} || words == Words{"--man"}) {
    std::cout << (words[0] == "--man" ? finemote::emulator::manual_page() : finemote::emulator::usage());
    return 0;
  }
  const auto options = finemote::emulator::watch_options(words);
  if (!options) {
    std::fputs(finemote::emulator::usage().c_str(), stderr);
    return 2;
  }
  return finemote::emulator::watch(*options, std::cout) ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  take_memory_in_large_pieces();
  try {
    const int status = run(Words(words + 1, words + count));
    if (!std::cout.flush()) throw std::runtime_error("cannot write to stdout");
    return status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
