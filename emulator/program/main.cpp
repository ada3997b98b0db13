// finemote-emulator JOB RECORD: runs the job in the file JOB and writes what the board did to the file RECORD.
// finemote-emulator --image ELF [...]: runs any image for the chip and tells what its pins, buses and parts did.
//
// A program of its own, so that whatever an image makes of the board cannot take the tool along; `finemote run` starts
// it.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "emulator/program/job.hpp"
#include "emulator/program/watch.hpp"
#include "generator/units/units.hpp"

namespace {

using Words = std::vector<std::string>;

constexpr const char* kUsage =
    "usage: finemote-emulator JOB RECORD\n"
    "       finemote-emulator --image ELF [--board NAME|FILE] [--duration TIME] [--scenario FILE] [--crystal HZ]\n"
    "                         [--flash hit|miss] [--format text|json]\n"
    "TIME is for example 500ms or 2s; a bare number counts ms\n";

void run_job(const std::string& job_file, const std::string& record_file) {
  std::ifstream job(job_file);
  const auto record = finemote::emulator::run_job(nlohmann::ordered_json::parse(job));
  std::ofstream file(record_file, std::ios::binary | std::ios::trunc);
  file << record << "\n";
  file.close();
  if (!file) throw std::runtime_error("cannot write the record");
}

/// A whole number of up to `digits` digits, not 0; nothing where it is none.
std::optional<std::uint64_t> number(const std::string& word, std::size_t digits) {
  if (word.empty() || word.size() > digits || word.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const std::uint64_t value = std::stoull(word);
  return value == 0 ? std::nullopt : std::optional(value);
}

/// `500ms`, or a bare number of ms; not 0, at most a day.
std::optional<std::uint64_t> duration_ns(const std::string& word) {
  if (const auto ms = number(word, 8)) return *ms * 1'000'000;
  const auto duration = finemote::gen::units::parse_duration(word);
  if (!duration || (*duration).ns() <= 0 || (*duration).ns() > 86'400'000'000'000) return std::nullopt;
  return static_cast<std::uint64_t>((*duration).ns());
}

/// The options of a watch, or nothing where the words are none.
std::optional<finemote::emulator::WatchOptions> watch_options(const Words& words) {
  finemote::emulator::WatchOptions options;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
    const std::string &key = words[i], &value = words[i + 1];
    if (key == "--image") {
      options.image = value;
    } else if (key == "--board") {
      options.board = value;
    } else if (key == "--scenario") {
      options.scenario = value;
    } else if (const auto ns = duration_ns(value); key == "--duration" && ns) {
      options.duration_ns = *ns;
    } else if (const auto hz = number(value, 8); key == "--crystal" && hz) {
      options.crystal_hz = static_cast<std::uint32_t>(*hz);
    } else if (key == "--flash" && (value == "hit" || value == "miss")) {
      options.flash_misses = value == "miss";
    } else if (key == "--format" && (value == "text" || value == "json")) {
      options.as_document = value == "json";
    } else {
      return std::nullopt;
    }
  }
  if (words.size() % 2 != 0 || options.image.empty()) return std::nullopt;
  return options;
}

int run(const Words& words) {
  if (words.size() == 2 && words[0].compare(0, 2, "--") != 0) {
    run_job(words[0], words[1]);
    return 0;
  }
  const auto options = watch_options(words);
  if (!options) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  return finemote::emulator::watch(*options, std::cout) ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(Words(words + 1, words + count));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
