: >robot.urdf
finemote generate robot.urdf -o out
