#!/bin/sh
# Makes meshes of the palpation anew and compares groups and counts with the committed files:
# remake_mesh.sh SOURCE_FOLDER WORK_FOLDER. Exit 77 (skipped) with another Gmsh than the one that made them. Only
# counts are compared: the last digits of a coordinate may depend on the processor's mathematical library.
set -eu
source=$1 work=$2
made_with=4.8.4
version=$(gmsh --version 2>&1)
if [ "$version" != "$made_with" ]; then
  echo "skipped: gmsh $version is here, the meshes were made with $made_with"
  exit 77
fi

# Groups with their names, and how many nodes and elements each part of the geometry has.
summary() {
  awk '/^\$/ { section = $1; line = 0; left = 0; next }
       { line++ }
       section == "$PhysicalNames" || ((section == "$Nodes" || section == "$Elements") && line == 1) { print; next }
       section == "$Elements" && left == 0 { print; left = $4; next }
       section == "$Elements" { left-- }' "$1"
}

for name in rectum prostate; do
  rm -f "$work/$name.msh"
  "$source/data/scripts/make-meshes" "$work" "$name"
  summary "$source/data/meshes/$name.msh" > "$work/$name.committed"
  summary "$work/$name.msh" > "$work/$name.made"
  [ -s "$work/$name.made" ]
  diff "$work/$name.committed" "$work/$name.made" || { echo "$name: the geometry makes another mesh"; exit 1; }
done
