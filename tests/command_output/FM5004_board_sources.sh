# what nobody wrote with 'board sources' stays; what it wrote is written again
mkdir folder
echo '// my own file' >folder/board.cmake
finemote board sources robomaster_type_c -o folder
cat folder/board.cmake
ls folder
finemote board sources robomaster_type_c -o other >said && head -1 said
sed -i 's/kCoreHz = 168/kCoreHz = 100/' other/board/clocks.hpp
sed -i 's/OFF/ON/' other/board.cmake
finemote board sources robomaster_type_c -o other
