# The system's signal for used up time, sent by hand once the limit is in force; and less memory than the input takes.
mkfifo slowly
finemote xacro - --sandbox <slowly & tool=$!
exec 3>slowly
while kill -0 $tool && ! grep -q 'Max cpu time  *60 ' "/proc/$tool/limits"; do sleep 0.01; done
kill -XCPU $tool; wait $tool; echo "time: $?"
exec 3>&-
{ echo '<robot name="rover">'; seq -f '  <link name="link_%.0f"/>' 500000; echo '</robot>'; } >large.urdf
(ulimit -v 200000; finemote analyze large.urdf --sandbox; echo "memory: $?")
