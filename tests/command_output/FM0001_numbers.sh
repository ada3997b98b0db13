for seed in -1 18446744073709551616 1.5 0x10 18446744073709551615; do
  finemote simulate "$source/examples/two_devices.urdf" --duration 1ms --seed "$seed" | head -n 1
done
finemote simulate "$source/examples/two_devices.urdf" --duration 999999999s
finemote run "$source/examples/two_devices.urdf" --duration 9223372036854775807ns
