#!/bin/sh
# Makes the fixtures of this folder again. Needs Debian 12's gmsh and python3-vtk9.
set -eu
cd "$(dirname "$0")"
gmsh two_boxes.geo -3 -format msh22 -o two_boxes.v22.text.msh
gmsh two_boxes.geo -3 -format msh22 -bin -o two_boxes.v22.binary.msh
gmsh two_boxes.geo -3 -format msh41 -o two_boxes.v41.text.msh
gmsh two_boxes.geo -3 -format msh41 -bin -o two_boxes.v41.binary.msh
gmsh two_boxes.geo -3 -format msh41 -order 2 -o second_order.msh
gmsh two_boxes.geo -3 -format vtk -o two_boxes.vtk
/usr/bin/python3 make_vtu.py
rm two_boxes.vtk
