finemote genrate robot.urdf -o out
