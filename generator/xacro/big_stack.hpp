// Runs a deep recursion where it cannot overflow.
#pragma once

#include <functional>

namespace finemote::gen::xacro {

/// Calls `work` on a thread with a stack of 512 MiB (reserved, not occupied) and waits for it; passes exceptions on.
void run_on_big_stack(const std::function<void()>& work);

}  // namespace finemote::gen::xacro
