# Installs on Debian 12, as root, what the project is built with. FINEMOTE_DEB is FineMote's package: a path or a URL.
set -eu
: "${FINEMOTE_DEB:?set it to the path or URL of the package of FineMote (README.md)}"
apt-get update
apt-get install -y --no-install-recommends ca-certificates curl git cmake ninja-build g++ gcc-arm-none-eabi \
  libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib
deb=$(mktemp -d)/finemote.deb
case $FINEMOTE_DEB in
  http://* | https://*) curl -fsSL -o "$deb" "$FINEMOTE_DEB" ;;
  *) cp "$FINEMOTE_DEB" "$deb" ;;
esac
chmod 755 "${deb%/*}"
apt-get install -y --no-install-recommends "$deb"
rm -r "${deb%/*}"
