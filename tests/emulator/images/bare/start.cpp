// What every program here starts with: a vector table, memory as C++ expects it, then main.
#include <cstdint>

extern "C" {
extern std::uint32_t stack_top, data_begin, data_end, data_image, bss_begin, bss_end;
// By another name, as C++ lets no program call its main.
int enter_main() __asm__("main");

void Default_Handler() {
  for (;;) {}
}

void Reset_Handler() {
  const std::uint32_t* from = &data_image;
  for (std::uint32_t* to = &data_begin; to < &data_end; ++to) *to = *from++;
  for (std::uint32_t* to = &bss_begin; to < &bss_end; ++to) *to = 0;
  *reinterpret_cast<volatile std::uint32_t*>(0xE000ED88) |= 0xFU << 20;  // CPACR: the FPU
  asm volatile("dsb\n isb");
  enter_main();
  Default_Handler();
}

// A program that has none of these has the one above.
void SVC_Handler();
void PendSV_Handler();
void SysTick_Handler();
void CAN1_RX1_IRQHandler();
void DMA2_Stream1_IRQHandler();
void DMA2_Stream6_IRQHandler();
void EXTI0_IRQHandler();
void TIM8_TRG_COM_TIM14_IRQHandler();
void USART3_IRQHandler();
void USART6_IRQHandler();
}

#define FINEMOTE_WEAK(name) asm(".weak " #name "\n.thumb_set " #name ", Default_Handler")
FINEMOTE_WEAK(SVC_Handler);
FINEMOTE_WEAK(PendSV_Handler);
FINEMOTE_WEAK(SysTick_Handler);
FINEMOTE_WEAK(CAN1_RX1_IRQHandler);
FINEMOTE_WEAK(DMA2_Stream1_IRQHandler);
FINEMOTE_WEAK(DMA2_Stream6_IRQHandler);
FINEMOTE_WEAK(EXTI0_IRQHandler);
FINEMOTE_WEAK(TIM8_TRG_COM_TIM14_IRQHandler);
FINEMOTE_WEAK(USART3_IRQHandler);
FINEMOTE_WEAK(USART6_IRQHandler);
#undef FINEMOTE_WEAK

namespace {

using Handler = void (*)();
struct Vectors {
  const void* stack = &stack_top;
  Handler exceptions[97] = {};
};

constexpr Vectors make_vectors() {
  Vectors vectors;
  const auto put = [&vectors](unsigned exception, Handler handler) { vectors.exceptions[exception - 1] = handler; };
  for (unsigned exception = 1; exception <= 97; ++exception) put(exception, Default_Handler);
  put(1, Reset_Handler);
  put(11, SVC_Handler);
  put(14, PendSV_Handler);
  put(15, SysTick_Handler);
  put(16 + 6, EXTI0_IRQHandler);
  put(16 + 21, CAN1_RX1_IRQHandler);
  put(16 + 39, USART3_IRQHandler);
  put(16 + 45, TIM8_TRG_COM_TIM14_IRQHandler);
  put(16 + 57, DMA2_Stream1_IRQHandler);
  put(16 + 69, DMA2_Stream6_IRQHandler);
  put(16 + 71, USART6_IRQHandler);
  return vectors;
}

[[gnu::section(".vectors"), gnu::used]] constexpr Vectors kVectors = make_vectors();

}  // namespace
