// Every interface a device can offer or ask for.
#pragma once

#include "finemote/interfaces/any.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/interfaces/magnetometer.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/pressure.hpp"
#include "finemote/interfaces/remote.hpp"
#include "finemote/interfaces/servo.hpp"
#include "finemote/interfaces/thruster.hpp"
