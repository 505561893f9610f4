// An include that points up and a library that has to be hidden: the test of
// the layers must find both.
#include <vtkPolyData.h>

#include "prosup/mesh/below.h"
