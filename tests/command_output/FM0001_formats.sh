for format in json sarif github gcc; do
  echo "== $format"
  finemote --format $format generate
  finemote lint --format=$format robot.urdf --alow FM3153
done
