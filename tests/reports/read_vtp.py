# SPDX-License-Identifier: MIT
# Prints a VTP file as VTK's own reader sees it: first the instant, then a line a grain, then the vertices.
import sys

try:
    import vtk
except ImportError:
    sys.exit("python3-vtk9 is missing")

reader = vtk.vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
if reader.GetErrorCode():
    sys.exit("VTK cannot read " + sys.argv[1])
data = reader.GetOutput()
arrays = data.GetPointData()
print(repr(data.GetFieldData().GetArray("TimeValue").GetValue(0)))
for k in range(data.GetNumberOfPoints()):
    values = list(data.GetPoint(k))
    for name in ("id", "radius", "diameter", "velocity", "spin", "fixed"):
        values += arrays.GetArray(name).GetTuple(k)
    print(*map(repr, values))
print(*[data.GetCell(k).GetPointId(0) for k in range(data.GetNumberOfCells())])
