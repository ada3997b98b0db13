# For scripts of tests, which source it: no settings of whoever runs them, and one language.
mapfile -t settings <"$(dirname "${BASH_SOURCE[0]}")/settings_of_users.txt"
unset "${settings[@]}" settings
export LC_ALL=C
