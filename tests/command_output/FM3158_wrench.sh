hull_type
jointed_robot "$(
  joint f1_joint continuous base_link f1_link "0.156 0.111 0.07" "0.7071 -0.7071 0"
  joint f2_joint continuous base_link f2_link "0.156 -0.111 0.07" "0.7071 0.7071 0"
  joint f3_joint continuous base_link f3_link "-0.156 0.111 0.07" "0.7071 0.7071 0"
  joint f4_joint continuous base_link f4_link "-0.156 -0.111 0.07" "0.7071 -0.7071 0"
  joint v1_joint continuous base_link v1_link "0 0.22 0.05" "0 0 1"
  joint v2_joint continuous base_link v2_link "0 -0.22 0.05" "0 0 1"
)" <<X
$(pwm_expander)
$(hull f1_joint f2_joint f3_joint f4_joint v1_joint v2_joint)
X
finemote lint robot.urdf --allow FM3153
finemote lint robot.urdf --allow FM3153 --deny 3158 | head -1
finemote lint robot.urdf --allow FM3153 --allow FM3158
finemote tree robot.urdf --format json | grep base_link
