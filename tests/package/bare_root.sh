#!/usr/bin/env bash
# bare_root.sh DEB ROOT: installs the package into ROOT, a Debian root with nothing but its essential packages (for example of
# `debootstrap --variant=minbase bookworm ROOT`), and runs every step of a new project's CI there. Needs root, the network and
# some minutes, so no test starts it by itself.
set -euo pipefail
deb=$(realpath "$1")
root=$(realpath "$2")
in_root() { chroot "$root" env -i -C / HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
trap 'umount -q "$root/proc" "$root/dev" || true' EXIT
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp "$deb" "$root/root/finemote.deb"

# The project comes from the package; its own ci/install.sh then installs the rest, and the package again.
in_root apt-get update -qq
in_root sh -c 'dpkg --list | cut -c 5- | sort >/root/before'
in_root apt-get install -y -qq --no-install-recommends /root/finemote.deb
in_root rm -rf /root/rover
in_root finemote init /root/rover
steps=$(sed -nE 's/^    - (.*)$/\1/p' "$root/root/rover/.gitlab-ci.yml")
while IFS= read -r step; do
  printf '== %s\n' "$step"
  in_root FINEMOTE_DEB=/root/finemote.deb sh -c "cd /root/rover && $step" </dev/null
done <<<"$steps"

# Removing it leaves nothing.
in_root apt-get purge -y -qq finemote
left=$(in_root sh -c "find / -xdev -path /proc -prune -o -path /root -prune -o -path /var/log -prune -o -name '*finemote*' -print")
[ -z "$left" ] || { printf 'left behind:\n%s\n' "$left"; exit 1; }
echo "the package installs, builds a project and leaves nothing"
