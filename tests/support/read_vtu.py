"""Prints what meshio finds in a .vtu file, doubles as hexadecimal bits, for tests/joints/files/vtu.rs."""

import json
import struct
import sys

try:
    import meshio
except ImportError:
    sys.exit("this Python has no meshio: install it with `pip install meshio==5.3.5`")


def bits(array):
    return " ".join(struct.pack(">d", v).hex() for v in array.ravel().tolist())


def components(array):
    return array.shape[1] if array.ndim > 1 else 1


mesh = meshio.read(sys.argv[1])
print("points", components(mesh.points), bits(mesh.points))
for block in mesh.cells:
    print("cells", block.type, " ".join(str(n) for n in block.data.ravel().tolist()))
for name, array in mesh.point_data.items():
    print("point", json.dumps(name), components(array), bits(array))
for name, arrays in mesh.cell_data.items():
    for array in arrays:
        print("cell", json.dumps(name), components(array), bits(array))
for name, array in mesh.field_data.items():
    print("field", json.dumps(name), components(array), bits(array))
