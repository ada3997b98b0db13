# init and scaffold overwrite nothing; other files do not matter
mkdir -p rover/src
echo mine >rover/NOTES
finemote init rover; echo "exit $?"
echo mine >rover/README.md
finemote init rover 2>&1 | tail -3
cat rover/README.md rover/NOTES
(cd rover && finemote scaffold device sonar && finemote scaffold device sonar; echo "exit $?")
finemote scaffold device Sonar; echo "exit $?"
finemote scaffold device class; echo "exit $?"
finemote scaffold device std; echo "exit $?"
finemote scaffold device led; echo "exit $?"
finemote scaffold board qemu_f405; echo "exit $?"
finemote scaffold board my_board -o boards --format json; echo "exit $?"
finemote scaffold board my_board -o boards; echo "exit $?"
finemote init other --board robomaster_type_d; echo "exit $?"
finemote init other --example finrov; echo "exit $?"
finemote init other --example finsrov --board qemu_f405; echo "exit $?"
finemote init other period:=20ms; echo "exit $?"
[ ! -e other ] && echo 'nothing was written'
