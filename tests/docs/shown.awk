# awk -f shown.awk SHOWN SAID: every line of SHOWN is one of SAID, in this order. A number in SHOWN may have fewer digits.

# Whether a number was shown as it was printed, as far as its digits go.
function is_number(word) { return word ~ /^-?[0-9]+([.][0-9]+)?(e-?[0-9]+)?$/ }
function same_word(shown, said,    digits) {
  if (shown == said) return 1
  if (!is_number(shown) || !is_number(said)) return 0
  digits = index(shown, ".") ? length(shown) - index(shown, ".") : 0
  return sprintf("%." digits "f", said) == shown
}
function same_line(shown, said,    n, i, a, b) {
  if (shown == said) return 1
  gsub(/[,:]/, " & ", shown)
  gsub(/[,:]/, " & ", said)
  n = split(shown, a)
  if (n == 0 || split(said, b) != n) return 0
  for (i = 1; i <= n; i++) if (!same_word(a[i], b[i])) return 0
  return 1
}

FNR == NR { shown[++count] = $0; next }
seen < count && same_line(shown[seen + 1], $0) { seen++ }
END {
  if (seen == count) exit 0
  print "not printed: " shown[seen + 1]
  exit 1
}
