# a name that is no UTF-8 is still a finding in every format, not an internal error
for format in text gcc github sarif json; do
  finemote check $'no\xff.urdf' -o out --format $format >said
  echo "exit $? $format"
  grep -o 'FM0002' said | head -1
done
printf '<robot name="r"><link name="base_link"/><finemote version="1"><board name="host"/>' >$'ok\xff.urdf'
printf '<device name="load" type="sim_load" period="10ms"/></finemote></robot>\n' >>$'ok\xff.urdf'
finemote analyze $'ok\xff.urdf' --dump model | grep -c sim_load
