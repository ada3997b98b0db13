# Commands that compile or write a stranger's files have no sandbox to offer.
robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote run robot.urdf --sandbox; echo "run: $?"
finemote lint robot.urdf --sandbox --fix; echo "lint --fix: $?"
finemote diff robot.urdf robot.urdf --sandbox --sizes; echo "diff --sizes: $?"
mkdir folder; finemote diff robot.urdf folder --sizes
finemote tree /robot.urdf --sandbox
