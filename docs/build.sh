#!/usr/bin/env bash
# build.sh FINEMOTE: writes the parts of the reference pages that are made from descriptors and board files, and the pages of
# the API, which are made from the comments of the headers. What people wrote around them stays; a second run changes nothing.
set -euo pipefail
docs=$(dirname "${BASH_SOURCE[0]}")
"$1" docs -o "$docs/reference"
"$docs/pictures.sh" "$1"
"$docs/screenshots.py" "$1" || [ $? -eq 77 ]
exec "$docs/api.py"
