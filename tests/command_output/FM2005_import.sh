# import gives a robot back, whatever stands behind its end
echo '<foo name="r"><ros2_control name="a" type="system"/></foo>' >foo.urdf
finemote import foo.urdf -o out.urdf
ls out.urdf 2>/dev/null
printf '%s\n' '<robot name="r"><link name="base_link"/><ros2_control name="a" type="system"/>' '</robot>' '<!-- end of' '</robot>' '-->' >behind.urdf
finemote import behind.urdf -o behind.out.urdf -q
tail -4 behind.out.urdf
finemote tree behind.out.urdf >/dev/null 2>said; grep -c FM1001 said
printf '<?xml version="1.0" encoding="ISO-8859-1"?>\n<robot name="r"><!-- gr\xfc\xdfe --><ros2_control name="a" type="system"/></robot>\n' >latin.urdf
finemote import latin.urdf -o latin.out.urdf -q
ls latin.out.urdf 2>/dev/null
finemote import - -o piped.urdf -q <behind.urdf; grep -c '<finemote' piped.urdf
