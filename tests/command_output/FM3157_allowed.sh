# every finding of lint can be allowed and denied, this one too
sed '/^finemote/d' "$cases/FM3157_param_replaced.sh" >make.sh
. ./make.sh
for code in $(cd "$source/docs/diagnostics" && ls FM31[5-9]?.md | sed 's/\.md//') FM4021; do
  finemote -q lint robot.urdf --allow $code --deny $code >said 2>&1 || { echo "$code:"; cat said; }
done
finemote lint robot.urdf --allow FM3153 --allow FM3157 && finemote lint robot.urdf --allow FM3153 --deny 3157
