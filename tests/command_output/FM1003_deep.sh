{ yes '<a>' | head -5000; yes '</a>' | head -5000; } | tr -d '\n' >robot.urdf
finemote generate robot.urdf -o out
