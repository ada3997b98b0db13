// Where an object lives when it may not live just anywhere.
#pragma once

/// A buffer that DMA reads or writes: never in the core-coupled RAM, which DMA cannot reach; not zeroed at start.
/// @code FINEMOTE_DMA static std::uint8_t buffer[64]; @endcode
#if defined(__arm__)
#define FINEMOTE_DMA __attribute__((section(".dma_buffers"), aligned(4)))
/// Core-coupled RAM: fast and free of DMA traffic, zeroed at start (no initial value may be given).
#define FINEMOTE_CORE_RAM __attribute__((section(".core_bss")))
#else
#define FINEMOTE_DMA alignas(4)
#define FINEMOTE_CORE_RAM
#endif
