// Follows tags through the machine: registers, memory, and the words that cross the bus to peripherals.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "emulator/core/interrupted.hpp"
#include "emulator/core/operation.hpp"
#include "emulator/core/provenance.hpp"
#include "emulator/core/registers.hpp"

namespace finemote::emulator {

/// Bytes keep their tags where they are copied, shifted, masked and put together. What is computed of several bytes has
/// the newest of their tags. A conditional instruction may leave what was there: the newer of the two, unless its block
/// has one for the other case. Addresses, conditions and flags carry nothing on.
///
/// What is pushed on the stack or spilled to it comes back as it was: such stores are no writes of a handle, such loads
/// take nothing.
class TagFlow {
 public:
  explicit TagFlow(Provenance& provenance) : provenance_(provenance) {}

  /// From now on; what is in memory and registers has no tags.
  void turn_on();
  [[nodiscard]] bool is_on() const { return !ram_.empty(); }

  /// `o` is about to execute. @param is_conditional  inside an IT block
  void follow(const Operation& o, const Registers& registers, bool is_conditional, Time now) {
    // Most of what runs moves nothing that has a tag.
    if (is_among(o.kind, Opcode::and_imm, Opcode::adr) ? is_untagged(r_[o.d], r_[o.n], r_[o.m]) : is_plain_jump(o.kind))
      return;
    follow_tags(o, registers, is_conditional, now);
  }
  /// A word of a peripheral has been loaded; its tags are in `crossing`.
  void take_answer(unsigned bytes, Time now);
  /// A word is about to be stored to a peripheral: puts its tags in `crossing`.
  void give_stored();
  /// Tags of the word that crosses the bus to a peripheral or back, its lowest byte first.
  WordTags crossing{};

  /// Tags of up to four bytes of memory that something else than the processor moves.
  [[nodiscard]] WordTags in_memory(std::uint32_t address, unsigned bytes);
  void put_in_memory(std::uint32_t address, unsigned bytes, const WordTags& tags);

  // Exceptions: the registers of what they interrupt come back.
  void enter(std::uint32_t frame);
  void resume(std::uint32_t frame);
  void reset();

  [[nodiscard]] const WordTags& of_register(unsigned number) const { return r_[number]; }

 private:
  struct File {
    std::array<WordTags, 16> r{};
    std::array<WordTags, 32> s{};
  };
  /// What a load makes of the bytes it finds.
  struct Width {
    unsigned bytes;
    bool is_signed;
  };

  static bool is_plain_jump(Opcode kind) { return kind == Opcode::b || kind == Opcode::b_cond; }
  void follow_tags(const Operation& o, const Registers& registers, bool is_conditional, Time now);
  std::span<Tag> find(std::uint32_t address, unsigned bytes);
  void set(WordTags& to, const WordTags& tags);
  void load(std::uint32_t address, Width width, WordTags& to);
  void arrive(Width width, WordTags& to, WordTags tags);
  void store(std::uint32_t address, unsigned bytes, const WordTags& tags);
  void access(unsigned which, std::uint32_t address, unsigned t);

  [[nodiscard]] WordTags last_operand(const Operation& o, unsigned form) const;
  void process(const Operation& o);
  void process_form(const Operation& o, unsigned what, unsigned form);
  void move_bits(const Operation& o, const Registers& registers);
  void extend(const Operation& o);
  void multiply(const Operation& o);
  void media(const Operation& o);
  void memory(const Operation& o, const Registers& registers);
  void indexed(const Operation& o, const Registers& registers);
  void multiple(const Operation& o, const Registers& registers);
  void exclusive(const Operation& o, const Registers& registers);
  void float_memory(const Operation& o, const Registers& registers);
  void floating(const Operation& o);

  /// A word that comes from or goes to a peripheral.
  struct Crossing {
    Width width;
    WordTags tags;
    WordTags* to;
  };

  Provenance& provenance_;
  std::vector<Tag> ram_, core_ram_;
  File file_;
  std::array<WordTags, 16>& r_ = file_.r;
  std::array<WordTags, 32>& s_ = file_.s;
  Interrupted<File> interrupted_;
  std::array<Crossing, 32> crossings_{};
  unsigned planned_ = 0, crossed_ = 0;
  bool in_choice_ = false;  ///< the last IT block writes in either case
  bool may_leave_ = false;  ///< in the other case this instruction leaves what was there
  bool is_spill_ = false;
  Time now_ = 0;
};

}  // namespace finemote::emulator
