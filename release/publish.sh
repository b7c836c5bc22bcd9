#!/usr/bin/env bash
# Checks that the crates and wheels can be published, and prints the commands of a maintainer: release/publish.sh [FOLDER]
#
# FOLDER has the files of release/build.sh (target/release-files by default). Nothing is published, and nothing is compiled.
#
# - version and authors are the same in Cargo.toml, CITATION.cff, python/pyproject.toml and the names of the files;
# - the version has a section in CHANGELOG.md;
# - `cargo publish --dry-run --no-verify` accepts each published crate, in order;
# - `twine check` accepts the wheels.
set -euo pipefail
cd "$(dirname "$0")/.."
files=${1:-target/release-files}
tools=target/publish-tools

python3 release/consistent.py "$files"

order=$(python3 release/consistent.py --order)
mapfile -t crates <<< "$order"
echo "== cargo publish --dry-run: ${crates[*]}"
cargo publish --dry-run --quiet --locked --no-verify --allow-dirty --target-dir target/publish "${crates[@]/#/-p}"
find target/publish/package -name '*.crate' -path '*tmp-crate*' -exec ls -l {} + | awk '{ print $5, $9 }'

wheels=("$files"/gaitcam-*.whl)
if [ -e "${wheels[0]}" ]; then
  echo "== twine check"
  [ -x "$tools/bin/twine" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet --disable-pip-version-check twine; }
  "$tools/bin/twine" check --strict "${wheels[@]}"
else
  echo "no wheels in $files: release/build.sh $files package"
fi

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n1)
cat <<TEXT

== The commands of a maintainer, on a clean clone of the commit to publish
.ci/run && .ci/platforms && release/twice.sh
git tag -a v$version -m "gaitcam $version" && git push origin v$version
$(printf 'cargo publish --locked -p %s\n' "${crates[@]}")
$tools/bin/twine upload ${wheels[*]}
Then attach all files of $files to the release of the tag v$version.
TEXT
