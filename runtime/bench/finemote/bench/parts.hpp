// Models of the parts that the shipped drivers speak to, to hang on the wires of the bench.
#pragma once

#include "runtime/boards/host/ports/h30_part.hpp"
#include "runtime/boards/host/ports/i2c_parts.hpp"
