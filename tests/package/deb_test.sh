#!/usr/bin/env bash
# deb_test.sh BUILD WORK: the Debian package, as CPack makes it of a build folder.
set -euo pipefail
mkdir -p "$2/prefix/bin"
. "$(dirname "$0")/common.sh" "$2/prefix" "$2/work"
build=$(realpath "$1")
cd "$work"
export SOURCE_DATE_EPOCH=1700000000

# pack NAME: a package in a folder of this name; its path is in `deb`.
pack() {
  holds "pack $1" cpack --config "$build/CPackConfig.cmake" -B "$work/$1"
  deb=$(echo "$work/$1"/finemote_*.deb)
}
pack first
first=$deb
. /etc/os-release
case $ID in debian) system=deb$VERSION_ID ;; *) system=$ID$VERSION_ID ;; esac
case $deb in *"~${system}_$(dpkg --print-architecture).deb") ;; *) fail "the name: $deb" ;; esac
sleep 1.1
pack second
equal "two packages of one commit" "$(sha256sum <"$deb")" "$(sha256sum <"$first")"

# What it needs and recommends, and what it holds.
field() { dpkg-deb -f "$first" "$1"; }
case $(field Depends) in *libc6*libexpat1*libyaml-cpp*) ;; *) fail "Depends: $(field Depends)" ;; esac
case $(field Recommends) in *cmake*gcc-arm-none-eabi*) ;; *) fail "Recommends: $(field Recommends)" ;; esac
dpkg-deb -x "$first" root
for file in bin/finemote bin/finemote-emulator share/finemote/cmake/finemoteConfig.cmake share/doc/finemote/copyright \
  share/doc/finemote/changelog.gz share/man/man1/finemote.1.gz share/man/man1/finemote-emulator.1.gz share/bash-completion/completions/finemote \
  share/zsh/vendor-completions/_finemote share/fish/vendor_completions.d/finemote.fish share/finemote/templates/project/dot_gitignore; do
  [ -f "root/usr/$file" ] || fail "no $file"
done
for option in image board duration scenario crystal flash format; do
  zcat root/usr/share/man/man1/finemote-emulator.1.gz | grep -q "^.fB.-.-$option.fR" || fail "the manual page: no --$option"
done
equal "what is not below usr" "$(ls -A root)" "usr"
for licence in 'Apache License' 'Boost Software License' 'Mozilla Public License' 'valijson' 'capstone' 'CLI11'; do
  grep -qi "$licence" root/usr/share/doc/finemote/copyright || fail "copyright: no $licence"
done
zcat root/usr/share/doc/finemote/changelog.gz | grep -q 'Tue, 14 Nov 2023 22:13:20' || fail "the date of the changelog"
! grep -rla "$build" root >said || fail "the build folder is named in $(cat said)"
if command -v lintian >/dev/null; then
  holds "lintian" lintian --allow-root --fail-on error "$first"
else
  echo "lintian is missing: the package is not checked by it"
fi

# What is installed is newer than all that was compiled before, though the package has the dates of its commit.
dpkg-deb -e "$first" control
sleep 0.05
touch compiled
sleep 0.05
holds "postinst" env DPKG_ROOT="$work/root" control/postinst configure ""
equal "what is older than a build before it" \
  "$(find root/usr/bin root/usr/share/finemote -type f ! -newer compiled)" ""

# Unpacked anywhere it works. What a project builds with it, package_init_test shows.
PATH=$work/root/usr/bin:$PATH
holds "init" finemote init rover
holds "check" finemote check rover/src/robot.urdf -o rover/generated
holds "find_package" bash -c "cd rover && cmake --preset host"
