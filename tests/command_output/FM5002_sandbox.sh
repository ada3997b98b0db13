# Generated folders are strangers' too: links in them, and manifests that name what lies elsewhere.
echo 'token-5f2a' >token
robot <<'X'
    <device name="load" type="sim_load" period="10ms"/>
X
finemote generate robot.urdf -o a --sandbox -q; echo "generate: $?"
cp -r a b
rm b/schedule.hpp; ln -s ../token b/schedule.hpp
finemote diff a b --sandbox 2>&1 | grep -c token-5f2a; echo "diff: ${PIPESTATUS[0]}"
finemote check robot.urdf -o b --sandbox --diff; echo "check: $?"
finemote generate robot.urdf -o b --sandbox; echo "generate: $?"
cat token
cp a/schedule.hpp b/real; rm b/schedule.hpp; mv b/real b/schedule.hpp
sed -i 's#"trees/load.hpp"#"../token"#' b/finemote.manifest.json
finemote diff a b --sandbox 2>&1 | grep -c token-5f2a; echo "diff: ${PIPESTATUS[0]}"
mkfifo model.json
timeout 20 finemote diff model.json model.json; echo "a pipe: $?"
