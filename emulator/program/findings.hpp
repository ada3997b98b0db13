// A board that has run to what is to be said of it: how it ended, what was reported, and what the parts saw.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "emulator/board.hpp"
#include "emulator/outfit/outfit.hpp"

namespace finemote::emulator {

class Findings {
 public:
  /// @param stop  how the run ended
  Findings(Board& board, Outfit& outfit, Stop stop) : board_(board), outfit_(outfit), stop_(stop) {}

  /// It was not stopped by a fault, and every expectation of the scenario holds.
  [[nodiscard]] bool ran_as_expected() const;
  /// finemote.emulator/1.
  nlohmann::ordered_json document(const std::string& image);
  /// The same for people: lines that begin with `#`.
  void write_text(std::ostream& out);

 private:
  /// `hardfault`: the routine of a fault has not ended, `lockup`: a fault in it; null: neither.
  [[nodiscard]] const char* stopped() const;
  [[nodiscard]] const char* how_it_ended() const;

  Board& board_;
  Outfit& outfit_;
  Stop stop_;
};

}  // namespace finemote::emulator
