// A block of tissue that hangs from the chest: 15 x 15 x 15 mm, the body of the
// loading and unloading experiment of Eiben et al. (2016), appendix.
// gmsh -3 box.geo makes box.msh of it. Coordinates are LPS in mm: the chest is
// posterior, at y = 0.
SetFactory("Built-in");

edge = 15;      // mm
spacing = 2;    // wanted edge length of the tetrahedra, mm

Point(1) = {-edge / 2, 0, -edge / 2, spacing};
Point(2) = {edge / 2, 0, -edge / 2, spacing};
Point(3) = {edge / 2, 0, edge / 2, spacing};
Point(4) = {-edge / 2, 0, edge / 2, spacing};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
block[] = Extrude {0, -edge, 0} { Surface{1}; };

// Numbers as in all meshes of prosup: tissue 2 is fat, face 1 the chest wall,
// face 3 the skin.
Physical Surface("chest wall", 1) = {1};
Physical Surface("skin", 3) = {block[0], block[2], block[3], block[4], block[5]};
Physical Volume("fat", 2) = {block[1]};

Mesh.Optimize = 1;
Mesh.MshFileVersion = 4.1;
