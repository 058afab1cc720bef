// What every mesh here shares. Lengths are metres; mm is a millimetre.
SetFactory("OpenCASCADE");
General.NumThreads = 1;      // the same bits from every run of one Gmsh version
Mesh.RandomSeed = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 0;
Mesh.SaveAll = 0;            // only what belongs to a named group
Mesh.Algorithm = 6;          // Frontal-Delaunay: nearly equilateral triangles
Mesh.Algorithm3D = 1;        // Delaunay
Mesh.Smoothing = 20;
Mesh.Optimize = 1;
Mesh.OptimizeNetgen = 0;
mm = 0.001;
