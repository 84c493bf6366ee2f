#!/bin/sh
# Gradescope runs this once, when it makes the image: installs what radlab needs and builds the grader.
set -eu
cd "${RADLAB_AUTOGRADER:-/autograder}/source/radlab"
chmod +x radlab
./radlab check --help >/dev/null
