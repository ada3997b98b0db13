printf '<robot name="r">\n  <!-- H\xf6he -->\n</robot>\n' >robot.urdf
finemote generate robot.urdf -o out
