jointed_robot "$(
  joint pan_joint revolute base_link pan_link "0 0 0" "0 0 1" -3 1.5
  joint tilt_joint revolute base_link tilt_link "0 0 0" "0 0 1" -1.5708 1.5708
)" <<X
$(pwm_expander)
    <device name="pan" type="pwm_servo" period="20ms" bus="pwm" channel="0" joint="pan_joint"/>
    <device name="tilt" type="pwm_servo" period="20ms" bus="pwm" channel="1" joint="tilt_joint"/>
X
finemote lint robot.urdf --allow FM3153
finemote generate robot.urdf -o out
sed -n "/How far/,/};/p" out/constants.hpp
