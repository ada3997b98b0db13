# Colour as --color says; NO_COLOR has a word only in `auto`, which colours nothing here: this is no terminal.
robot <<'X'
    <device name="load" type="sim_lode" period="10ms"/>
X
lines_in_color() { "$@" 2>&1 | grep -c $'\e\\['; }
for when in always never auto; do
  echo "$when: $(lines_in_color finemote tree robot.urdf --color $when)"
  echo "$when, NO_COLOR: $(NO_COLOR=1 lines_in_color finemote tree robot.urdf --color $when)"
done
diff <(finemote tree robot.urdf --color always 2>&1 | sed 's/\x1b\[[0-9;]*m//g') <(finemote tree robot.urdf 2>&1) && echo "the same words"
finemote tree robot.urdf --color sometimes
finemote tree robot.urdf
