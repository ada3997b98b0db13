xacro_robot </dev/null
finemote xacro robot.urdf.xacro -o nowhere/at/all/../robot.urdf </dev/null
: >file
finemote xacro robot.urdf.xacro -o file/robot.urdf
