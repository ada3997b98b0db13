// Runs an image on QEMU and reads the run protocol it writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace finemote::test {

struct StageEvent {
  std::int64_t ns;
  unsigned stage;
  bool end;
};

struct Run {
  int status = -1;  ///< exit status of the image; 124: it was still running after 60 s
  std::string text;
  std::vector<StageEvent> events;
};

/// Image `name` of the images folder, with one instruction taking 8 ns: the same bytes on every run.
Run run_on_qemu(const std::string& name);

}  // namespace finemote::test
