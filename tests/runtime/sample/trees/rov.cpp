#include "rov.hpp"

#include <finemote/stage.hpp>

namespace Sample::rov {

using finemote::Stage;

void update_5ms() {
  { Stage stage{0}; imu.update(); }
  ports::imu_to_rov_latch.publish(imu.state);  // to rov (10 ms)
}

void handle_5ms() {
  imu.command = ports::rov_to_imu_latch.snapshot();  // from rov (10 ms)
  { Stage stage{1}; imu.handle(); }
}

void update_10ms() {
  { Stage stage{2}; left.update(); }
  { Stage stage{4}; right.update(); }
  ports::imu_to_rov = ports::imu_to_rov_latch.snapshot();  // from imu (5 ms)
  { Stage stage{6}; rov.update(); }
}

void handle_10ms() {
  { Stage stage{7}; rov.handle(); }
  ports::rov_to_imu_latch.publish(ports::rov_to_imu);  // to imu (5 ms)
  { Stage stage{5}; right.handle(); }
  { Stage stage{3}; left.handle(); }
}

}  // namespace Sample::rov
