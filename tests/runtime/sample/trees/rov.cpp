#include "rov.hpp"

#include <finemote/stage.hpp>

namespace Sample::rov {

using finemote::Stage;

void update_5ms() {
  { Stage<0> stage; imu.update(); }
  ports::imu_to_rov_latch.publish(imu.state);  // to rov (10 ms)
}

void handle_5ms() {
  imu.command = ports::rov_to_imu_latch.snapshot();  // from rov (10 ms)
  { Stage<1> stage; imu.handle(); }
}

void update_10ms() {
  { Stage<2> stage; left.update(); }
  { Stage<4> stage; right.update(); }
  ports::imu_to_rov = ports::imu_to_rov_latch.snapshot();  // from imu (5 ms)
  { Stage<6> stage; rov.update(); }
}

void handle_10ms() {
  { Stage<7> stage; rov.handle(); }
  ports::rov_to_imu_latch.publish(ports::rov_to_imu);  // to imu (5 ms)
  { Stage<5> stage; right.handle(); }
  { Stage<3> stage; left.handle(); }
}

}  // namespace Sample::rov
