// A steel block on a base plate, half of it (the plane y = 0 is a plane of symmetry). Lengths in mm.
// Everything here is plain gmsh. What `bracket analyse` needs are the physical groups at the end:
// physical volumes become bodies, physical surfaces become faces that the model file can name.
SetFactory("OpenCASCADE");

Box(1) = {-40, 0, -20, 80, 40, 20};  // plate: x from -40 to 40, y from 0 to 40, z from -20 to 0
Box(2) = {-20, 0, 0, 20, 20, 60};    // block, left half: x from -20 to 0
Box(3) = {0, 0, 0, 20, 20, 60};      // block, right half, so that the loaded half of the top is a face of its own

// The volumes share the faces where they meet; without this line their triangles would not match.
BooleanFragments{ Volume{1}; Delete; }{ Volume{2, 3}; Delete; }

// Faces are found by the box they lie in, which survives a change of the geometry better than their numbers.
e = 0.01;
top_right() = Surface In BoundingBox{-e, -e, 60 - e, 20 + e, 20 + e, 60 + e};
bottom() = Surface In BoundingBox{-40 - e, -e, -20 - e, 40 + e, 40 + e, -20 + e};
symmetry() = Surface In BoundingBox{-40 - e, -e, -20 - e, 40 + e, e, 60 + e};

Physical Volume("PLATE") = {1};
Physical Volume("BLOCK") = {2, 3};
Physical Surface("TOP_RIGHT") = {top_right()};
Physical Surface("BOTTOM") = {bottom()};
Physical Surface("SYMMETRY") = {symmetry()};

// Sizes: 13 mm, 7 mm around the contact, where the stress is steep.
MeshSize{ : } = 13;
MeshSize{ PointsOf{ Surface{Surface In BoundingBox{-20 - e, -e, -e, 20 + e, 20 + e, e}}; } } = 7;
Mesh.MeshSizeExtendFromBoundary = 1;
Mesh.ElementOrder = 1;  // bracket adds its own mid-side nodes
