truncate --size 65M robot.urdf
finemote generate robot.urdf -o out
