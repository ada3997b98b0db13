# a model that analyze refuses is refused by diff; two spellings of one model are no difference
model() { echo '{"tick_ns": 1000000, "devices": [{"name": '"$1"', "period_ns": 5000000, "update_wcet_ns": 10000, "handle_wcet_ns": 10000'"$2"'}]'"$3"'}'; }
model '"r"' >good.json
model '"r"' ', "parent": null' ', "buses": []' >same.json
model null >unnamed.json
model '"r"' ', "parent": "nobody"' >orphan.json
{ printf '{"a": '; printf '[%.0s' $(seq 60000); printf ']%.0s' $(seq 60000); printf '}'; } >deep.json
echo 'no model' >words.json
finemote diff good.json same.json; echo "exit $?"
for name in unnamed orphan deep words; do
  finemote diff good.json $name.json 2>said >/dev/null; echo "$name: exit $?"; cut -c-100 said
done
finemote analyze good.json x:=1
