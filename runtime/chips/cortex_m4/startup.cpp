// From reset to main: memory, FPU, and constructors where a robot has any.
#include <cstdint>

#include "runtime/chips/cortex_m4/registers.hpp"

extern "C" {
// Defined by sections.ld.
extern std::uint32_t _data_load, _data_begin, _data_end, _bss_begin, _bss_end, _core_bss_begin, _core_bss_end;
#ifdef FINEMOTE_CODE_IN_SRAM
extern std::uint32_t _dma_constants_load, _dma_constants_begin, _dma_constants_end;  // sections_sram.ld
#endif
using Constructor = void (*)();
extern Constructor __init_array_start[], __init_array_end[];
extern const std::uint32_t finemote_vectors[];
}

// By another name, as C++ lets no program call its main.
int enter_main() __asm__("main");

namespace {

void zero(std::uint32_t* begin, const std::uint32_t* end) {
  while (begin < end) *begin++ = 0;
}

/// What a boot loader has left enabled, pending or masked: behind this nothing interrupts but what is enabled later.
inline void forget_interrupts() {
  using namespace finemote::cortex_m4;
  systick::Control::write(0);
  nvic::disable_all();
  scb::InterruptControl::write(scb::kClearSysTick | scb::kClearPendSv);
  unmask_all();
}

}  // namespace

extern "C" [[noreturn]] void finemote_reset() {
  using namespace finemote::cortex_m4;
  forget_interrupts();  // what a boot loader has enabled has no routine here
  // A boot loader may have left its own: PM0214 4.4.4.
  scb::VectorTable::write(reinterpret_cast<std::uintptr_t>(finemote_vectors));
  // Before any function that may use an FPU register.
  scb::CoprocessorAccess::set(scb::kFpuFullAccess);
  barrier();
  const std::uint32_t* from = &_data_load;
  for (std::uint32_t* to = &_data_begin; to < &_data_end;) *to++ = *from++;
#ifdef FINEMOTE_CODE_IN_SRAM
  from = &_dma_constants_load;
  for (std::uint32_t* to = &_dma_constants_begin; to < &_dma_constants_end;) *to++ = *from++;
#endif
  zero(&_bss_begin, &_bss_end);
  zero(&_core_bss_begin, &_core_bss_end);
  for (Constructor* constructor = __init_array_start; constructor < __init_array_end; ++constructor) (*constructor)();
  enter_main();
  for (;;) {}
}
