# For scripts of tests, which source it: no settings of whoever runs them, and one language.
mapfile -t settings <"$(dirname "${BASH_SOURCE[0]}")/settings_of_users.txt"
unset "${settings[@]}" settings
export LC_ALL=C

# as_somebody PROGRAM WORD...: as somebody whom permissions hold: the superuser gives up the right to pass over them.
as_somebody() {
  [ "$(id -u)" = 0 ] || { "$@"; return; }
  # Without this capability setpriv drops nothing, and says nothing.
  setpriv --dump --dump | grep -q '^Effective capabilities:.*setpcap' || { setpriv --reuid 65534 --clear-groups "$@"; return; }
  setpriv --bounding-set=-dac_override,-dac_read_search --inh-caps=-dac_override,-dac_read_search "$@"
}
