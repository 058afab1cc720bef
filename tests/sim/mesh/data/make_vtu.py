"""Writes two_boxes.*.vtu in every encoding that VTK's own writer knows, from the legacy file that Gmsh wrote."""

import vtk

LEFT_END = 1e-9  # x of the group "fixed"

reader = vtk.vtkUnstructuredGridReader()
reader.SetFileName("two_boxes.vtk")
reader.Update()
grid = reader.GetOutput()

fixed = vtk.vtkUnsignedCharArray()
fixed.SetName("group.fixed")
for node in range(grid.GetNumberOfPoints()):
    fixed.InsertNextValue(1 if grid.GetPoint(node)[0] < LEFT_END else 0)

region = vtk.vtkIntArray()
region.SetName("region")
for cell in range(grid.GetNumberOfCells()):
    bounds = grid.GetCell(cell).GetBounds()
    region.InsertNextValue(7 if bounds[0] > 1 - 1e-9 else -1)

grid.GetCellData().Initialize()
grid.GetPointData().AddArray(fixed)
grid.GetCellData().AddArray(region)

MODES = {"ascii": 0, "inline": 1, "appended": 2}
for mode, number in MODES.items():
    for packing in ["plain"] if mode == "ascii" else ["plain", "zlib"]:
        for encoding in ["base64", "raw"] if mode == "appended" else [""]:
            for header in ["UInt32", "UInt64"] if mode != "ascii" else ["UInt32"]:
                for order in ["little", "big"] if header == "UInt64" else ["little"]:
                    writer = vtk.vtkXMLUnstructuredGridWriter()
                    writer.SetInputData(grid)
                    writer.SetDataMode(number)
                    writer.SetEncodeAppendedData(1 if encoding == "base64" else 0)
                    if packing == "zlib":
                        writer.SetCompressorTypeToZLib()
                        writer.SetBlockSize(1024 if header == "UInt32" else 32768)  # several blocks in some
                    else:
                        writer.SetCompressorTypeToNone()
                    writer.SetHeaderTypeToUInt32() if header == "UInt32" else writer.SetHeaderTypeToUInt64()
                    writer.SetByteOrderToLittleEndian() if order == "little" else writer.SetByteOrderToBigEndian()
                    parts = [mode, encoding, packing, header.lower(), order]
                    writer.SetFileName("two_boxes." + ".".join(p for p in parts if p) + ".vtu")
                    writer.Write()

writer = vtk.vtkXMLUnstructuredGridWriter()
writer.SetInputData(grid)
writer.SetCompressorTypeToLZ4()
writer.SetFileName("lz4.vtu")
writer.Write()
