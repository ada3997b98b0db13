timed_button '[]' '"0000000000000000000000000000000000000000000000000000000000000000"'
finemote check r.urdf -o out >said; status=$?
grep stale-timing said; exit $status
