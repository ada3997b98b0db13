robot <<'X'
    <bus name="sticks_uart" type="uart" port="usart3" baud="100000baud"/>
    <device name="sticks" type="dr16" bus="sticks_uart" period="10ms"/>
X
echo '{ "schema": "finemote.scenario/1" }' >scenario.json
finemote run robot.urdf --board host --scenario scenario.json
