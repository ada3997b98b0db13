// Every interface a device can offer or ask for.
#pragma once

#include "finemote/interfaces/any.hpp"
#include "finemote/interfaces/battery.hpp"
#include "finemote/interfaces/button.hpp"
#include "finemote/interfaces/imu.hpp"
#include "finemote/interfaces/light.hpp"
#include "finemote/interfaces/link.hpp"
#include "finemote/interfaces/magnetometer.hpp"
#include "finemote/interfaces/motor.hpp"
#include "finemote/interfaces/pressure.hpp"
#include "finemote/interfaces/remote.hpp"
#include "finemote/interfaces/servo.hpp"
#include "finemote/interfaces/sounder.hpp"
#include "finemote/interfaces/thruster.hpp"
