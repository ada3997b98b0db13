robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
for silicon in strict: lazy strict:dma_stor; do finemote run robot.urdf --silicon $silicon; echo "exit $?"; done
