#include "rov.hpp"

#include <finemote/stage.hpp>

namespace Rov14::rov {

using finemote::Stage;

void update_5ms() {
  { Stage stage{0}; imu.update(); }
#ifndef BENCH_WITHOUT_LATCH
  ports::imu_to_rov_latch.publish(imu.state);  // to rov (10 ms)
#endif
}

void handle_5ms() {
  { Stage stage{1}; imu.handle(); }
}

void update_10ms() {
  { Stage stage{2}; baro_1.update(); }
  { Stage stage{4}; baro_2.update(); }
  { Stage stage{6}; baro_3.update(); }
  { Stage stage{8}; baro_4.update(); }
  { Stage stage{10}; thruster_1.update(); }
  { Stage stage{12}; thruster_2.update(); }
  { Stage stage{14}; thruster_3.update(); }
  { Stage stage{16}; thruster_4.update(); }
  { Stage stage{18}; thruster_5.update(); }
  { Stage stage{20}; thruster_6.update(); }
  { Stage stage{22}; thruster_7.update(); }
  { Stage stage{24}; thruster_8.update(); }
#ifndef BENCH_WITHOUT_LATCH
  ports::imu_to_rov = ports::imu_to_rov_latch.snapshot();  // from imu (5 ms)
#endif
  { Stage stage{26}; rov.update(); }
}

void handle_10ms() {
  { Stage stage{27}; rov.handle(); }
  { Stage stage{25}; thruster_8.handle(); }
  { Stage stage{23}; thruster_7.handle(); }
  { Stage stage{21}; thruster_6.handle(); }
  { Stage stage{19}; thruster_5.handle(); }
  { Stage stage{17}; thruster_4.handle(); }
  { Stage stage{15}; thruster_3.handle(); }
  { Stage stage{13}; thruster_2.handle(); }
  { Stage stage{11}; thruster_1.handle(); }
  { Stage stage{9}; baro_4.handle(); }
  { Stage stage{7}; baro_3.handle(); }
  { Stage stage{5}; baro_2.handle(); }
  { Stage stage{3}; baro_1.handle(); }
}

}  // namespace Rov14::rov
