hull_type fx fz
jointed_robot "$(
  joint a_joint continuous base_link a_link "0.2 0 0" "0 0 1"
  joint b_joint continuous base_link b_link "-0.2 0 0" "0 0 1"
  joint c_joint continuous base_link c_link "0 0 0" "0.002 0 1"
)" <<X
$(pwm_expander)
$(hull a_joint b_joint c_joint)
X
finemote lint robot.urdf --allow FM3153
