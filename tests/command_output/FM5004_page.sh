mkdir -p pages/devices
echo '# my sensor' >pages/devices/h30_imu.md
finemote docs -o pages
status=$?
find pages -type f; cat pages/devices/h30_imu.md
exit $status
