"""Prints the entities that ezdxf finds in a DXF file, sorted, and the errors of its audit, for tests/commands/check/plate_dxf.rs."""

import sys

import ezdxf

document = ezdxf.readfile(sys.argv[1])
lines = [document.dxfversion, f"errors {len(document.audit().errors)}"]
for e in document.modelspace():
    kind, layer = e.dxftype(), e.dxf.layer
    if kind == "LINE":
        lines.append(f"{kind} {layer} {e.dxf.start.x:.6f} {e.dxf.start.y:.6f} {e.dxf.end.x:.6f} {e.dxf.end.y:.6f}")
    elif kind == "CIRCLE":
        lines.append(f"{kind} {layer} {e.dxf.center.x:.6f} {e.dxf.center.y:.6f} {e.dxf.radius:.6f}")
    else:
        lines.append(f"{kind} {layer} {e.dxf.text}")
print("\n".join(lines))
