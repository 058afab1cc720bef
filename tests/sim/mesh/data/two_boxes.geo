// Two unit cubes side by side. The volume group "right" lies within "all", so that a tetrahedron is in two groups;
// "ends" holds two surfaces; "fixed" is one of them; one corner is a group of its own.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
Physical Volume("all", 1) = {1, 2};
Physical Volume("right", 2) = {2};
Physical Surface("fixed", 3) = {1};
Physical Surface("ends", 4) = {1, 11};
Physical Curve("edge of the left end", 5) = {1};
Physical Point("corner", 9) = {1};
Mesh.MeshSizeMin = 1;
Mesh.MeshSizeMax = 1;
