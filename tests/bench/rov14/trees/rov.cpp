#include "rov.hpp"

#include <finemote/stage.hpp>

namespace Rov14::rov {

using finemote::Stage;

void update_5ms() {
  { Stage<0> stage; imu.update(); }
#ifndef BENCH_WITHOUT_LATCH
  ports::imu_to_rov_latch.publish(imu.state);  // to rov (10 ms)
#endif
}

void handle_5ms() {
  { Stage<1> stage; imu.handle(); }
}

void update_10ms() {
  { Stage<2> stage; baro_1.update(); }
  { Stage<4> stage; baro_2.update(); }
  { Stage<6> stage; baro_3.update(); }
  { Stage<8> stage; baro_4.update(); }
  { Stage<10> stage; thruster_1.update(); }
  { Stage<12> stage; thruster_2.update(); }
  { Stage<14> stage; thruster_3.update(); }
  { Stage<16> stage; thruster_4.update(); }
  { Stage<18> stage; thruster_5.update(); }
  { Stage<20> stage; thruster_6.update(); }
  { Stage<22> stage; thruster_7.update(); }
  { Stage<24> stage; thruster_8.update(); }
#ifndef BENCH_WITHOUT_LATCH
  ports::imu_to_rov = ports::imu_to_rov_latch.snapshot();  // from imu (5 ms)
#endif
  { Stage<26> stage; rov.update(); }
}

void handle_10ms() {
  { Stage<27> stage; rov.handle(); }
  { Stage<25> stage; thruster_8.handle(); }
  { Stage<23> stage; thruster_7.handle(); }
  { Stage<21> stage; thruster_6.handle(); }
  { Stage<19> stage; thruster_5.handle(); }
  { Stage<17> stage; thruster_4.handle(); }
  { Stage<15> stage; thruster_3.handle(); }
  { Stage<13> stage; thruster_2.handle(); }
  { Stage<11> stage; thruster_1.handle(); }
  { Stage<9> stage; baro_4.handle(); }
  { Stage<7> stage; baro_3.handle(); }
  { Stage<5> stage; baro_2.handle(); }
  { Stage<3> stage; baro_1.handle(); }
}

}  // namespace Rov14::rov
