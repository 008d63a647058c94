#!/usr/bin/env bash
# Sourced by tools/try-as-newcomer and tools/try-packages: a clean Debian 12 root, and commands in it. Needs $root.
# shellcheck shell=bash disable=SC2154

# What a newcomer's shell would have: his own environment, and the machine's way to the network.
inside() {
  local pass=(HOME=/root TERM=dumb LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
  for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY NODE_EXTRA_CA_CERTS SSL_CERT_FILE; do
    if [ -n "${!name:-}" ]; then pass+=("$name=${!name}"); fi
  done
  unshare --pid --fork --kill-child --mount --mount-proc="$root/proc" chroot "$root" env -i "${pass[@]}" bash -c "$1"
}

mirror="$(sed -n 's/^URIs: *//p; s/^deb \([^[ ]*\) .*/\1/p' /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources 2> /dev/null | head -n 1 || true)"
take_root() {
  # The installer of Debian writes this file, debootstrap does not.
  printf '127.0.0.1 localhost\n::1 localhost\n' > "$root/etc/hosts"
  mkdir -p "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/dev/shm"
}
make_root() {
  debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}"
  # The machine's way to packages: its mirrors, its proxies, its certificates; nothing that is installed on it.
  for file in /etc/apt/sources.list.d/debian.sources /etc/resolv.conf; do
    if [ -e "$file" ]; then mkdir -p "$root/$(dirname "$file")"; cp -L "$file" "$root$file"; fi
  done
  if [ -e "$root/etc/apt/sources.list.d/debian.sources" ]; then rm -f "$root/etc/apt/sources.list"; fi
  { apt-config dump | grep -iE '^Acquire::(https?::|Check-)' || true; } > "$root/etc/apt/apt.conf.d/90machine"
  for name in NODE_EXTRA_CA_CERTS SSL_CERT_FILE; do
    if [ -n "${!name:-}" ]; then mkdir -p "$root/$(dirname "${!name}")"; cp -L "${!name}" "$root${!name}"; fi
  done
  if ls /usr/local/share/ca-certificates/*.crt > /dev/null 2>&1; then
    mkdir -p "$root/usr/local/share/ca-certificates"
    cp /usr/local/share/ca-certificates/*.crt "$root/usr/local/share/ca-certificates/"
  fi
  take_root
}
# Leaves nothing mounted; false when something would not let go, and the root must then not be removed.
leave_root() {
  local place
  for place in "$@" proc dev/shm; do
    if mountpoint -q "$root/$place"; then umount -l "$root/$place"; fi
  done
  for place in "$@" proc dev/shm; do
    if mountpoint -q "$root/$place"; then echo "$root/$place is still in use" >&2; return 1; fi
  done
}
