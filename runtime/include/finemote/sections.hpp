// Where an object lives when it may not live just anywhere.
#pragma once

/// A buffer that DMA reads or writes: never in the core-coupled RAM, which DMA cannot reach; not zeroed at start.
/// @code FINEMOTE_DMA static std::uint8_t buffer[64]; @endcode
#if defined(__arm__)
#define FINEMOTE_DMA __attribute__((section(".dma_buffers"), aligned(4)))
/// A constant that a driver hands to DMA: with code in SRAM, DMA does not reach other constants. Not inside a function
/// template or an inline function.
/// @code FINEMOTE_DMA_CONSTANT static const std::uint8_t setup[] = {0x12, 0x34}; @endcode
#define FINEMOTE_DMA_CONSTANT __attribute__((section(".dma_constants"), aligned(4)))
/// Core-coupled RAM: fast and free of DMA traffic, zeroed at start (no initial value may be given).
#define FINEMOTE_CORE_RAM __attribute__((section(".core_bss")))
#else
#define FINEMOTE_DMA alignas(4)
#define FINEMOTE_DMA_CONSTANT alignas(4)
#define FINEMOTE_CORE_RAM
#endif
