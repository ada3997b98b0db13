robot <<'X'
    <bus name="can" type="can" port="can1" bitrate="1Mbit/s"/>
X
finemote generate robot.urdf -o out
