#!/usr/bin/env bash
# Two branches change the robot: Git merges no generated source, and the folder is made anew as .gitattributes and hints say.
. "$(dirname "$0")/common.sh"
cd "$work"
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@example.org GIT_COMMITTER_NAME=a \
  GIT_COMMITTER_EMAIL=a@example.org
cat >rover.urdf <<'X'
<robot name="rover">
  <link name="base_link"/>
  <finemote version="1">
    <board name="robomaster_type_c"/>
    <device name="base" type="group" period="10ms">
      <device name="left" type="sim_load"/>
      <device name="right" type="sim_load"/>
    </device>

    <!-- further trees -->
  </finemote>
</robot>
X
holds "init" finemote init rover --from rover.urdf
cd rover
git init -q -b main .
git add -A
git commit -qm "begin"

# change BRANCH SCRIPT: edits the robot, on a branch, with its generated sources.
change() {
  git checkout -q -b "$1" main
  sed -i "$2" src/rover.urdf
  finemote -q generate src/rover.urdf -o generated
  git add -A
  git commit -qm "$1"
}
change tree 's|.*further trees.*|    <device name="second" type="sim_load" period="20ms"/>|'
change device 's|      <device name="left".*|&\n      <device name="middle" type="sim_load"/>|'
refuses "the merge" "CONFLICT.*generated" git merge tree
equal "the robot is merged" "$(git diff --name-only --diff-filter=U | grep -v '^generated/' || true)" ""
! grep -rq '<<<<<<<' generated || fail "conflict marks in generated sources"
refuses "check" "stale\|hand-edited\|orphan" finemote check src/rover.urdf -o generated
refuses "generate over what was merged" "after a merge: rm -r 'generated', then generate again" finemote generate src/rover.urdf -o generated
holds "the folder anew" bash -c "rm -r generated && finemote generate src/rover.urdf -o generated"
holds "check" finemote check src/rover.urdf -o generated
holds "the merge is done" bash -c "git add -A && git commit -qm merged"
