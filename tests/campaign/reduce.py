"""Makes a failing input smaller while it fails in the same way."""

import copy
import time


def smaller(document, fails, tries, seconds=60):
    """Leaves out keys and entries of lists one after the other, from the outside in."""
    end = time.monotonic() + seconds
    places = list(walk(document))
    for path in places:
        if tries == 0 or time.monotonic() > end:
            break
        candidate = copy.deepcopy(document)
        if not drop(candidate, path):
            continue
        tries -= 1
        if fails(candidate):
            document = candidate
    return document


def walk(node, path=()):
    """Paths of all keys and entries, the outer ones first, entries of a list from its end."""
    if isinstance(node, dict):
        steps = list(node)
    elif isinstance(node, list) and any(isinstance(x, (dict, list)) for x in node):
        steps = list(range(len(node)))[::-1]
    else:
        return
    for step in steps:
        yield (*path, step)
    for step in steps:
        yield from walk(node[step], (*path, step))


def drop(document, path):
    for step in path[:-1]:
        try:
            document = document[step]
        except (KeyError, IndexError):
            return False
    try:
        del document[path[-1]]
    except (KeyError, IndexError):
        return False
    return True
