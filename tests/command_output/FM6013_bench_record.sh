# a record of a bench kit is judged, and what is none is said
printf 'no record here\n' >record.txt
finemote bench-kit --read record.txt; echo "exit $?"
finemote bench-kit --read missing.txt; echo "exit $?"
finemote bench-kit; echo "exit $?"
cat >part.txt <<'X'
12 usart6 text {"schema":"finemote.bench/1","board":"robomaster_type_c","robot":"bench","plan":"0","tests":[{"name":"clock.core_hz","value":84000000,"expected":null,"ok":true}],"not_done":[]}
X
finemote bench-kit --read part.txt | grep clock.core_hz
finemote bench-kit --read part.txt >all.txt; echo "exit $?"
