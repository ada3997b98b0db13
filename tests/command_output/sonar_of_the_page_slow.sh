# the device of docs/howto/add-a-device.md as the page has it: its execution times hold on the emulated board
mkdir devices
awk '/^<!-- file: /{file = $3} /^```/{inside = !inside && file != ""; if (!inside) file = ""; next} inside{print >file}' \
  "$source/docs/howto/add-a-device.md"
finemote run rover.urdf --duration 200ms 2>&1 | grep -E 'FM|error|transfers|overruns'
