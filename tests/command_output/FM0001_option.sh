finemote generate robot.urdf --ouput out
