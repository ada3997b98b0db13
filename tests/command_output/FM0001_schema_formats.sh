for format in json sarif github gcc; do
  echo "== $format"
  finemote --format $format schema
  finemote --format $format schema xsd | head -c 100
  finemote --format $format schema device | head -c 100
done
finemote schema nothing
