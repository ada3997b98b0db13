#!/usr/bin/env bash
# build.sh FINEMOTE: writes the parts of the reference pages that are made from descriptors and board files. What people
# wrote around them stays; a second run changes nothing.
set -euo pipefail
exec "$1" docs -o "$(dirname "${BASH_SOURCE[0]}")/reference"
