// finemote-emulator JOB RECORD: runs the job in the file JOB and writes what the board did to the file RECORD.
//
// A program of its own, so that whatever an image makes of the board cannot take the tool along; `finemote run` starts
// it.
#include <cstdio>
#include <exception>
#include <fstream>

#include "emulator/program/job.hpp"

int main(int count, char** words) {
  if (count != 3) {
    std::fputs("usage: finemote-emulator JOB RECORD\n", stderr);
    return 2;
  }
  try {
    std::ifstream job(words[1]);
    const auto record = finemote::emulator::run_job(nlohmann::ordered_json::parse(job));
    std::ofstream file(words[2], std::ios::binary | std::ios::trunc);
    file << record << "\n";
    file.close();
    if (!file) throw std::runtime_error("cannot write the record");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
