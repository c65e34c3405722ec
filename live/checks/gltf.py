"""glTF files of the command, read by three.js as viewers do."""
import csv
import json
import math
import pathlib
import subprocess
import tempfile

LIVE = pathlib.Path(__file__).resolve().parent.parent
TIMES = (0, 0.25, 2, 2.05, 3)  # [s] before and after a cube is shot
APART = 1e-5  # [m], [-] single precision of numbers up to 20


def poses(folder, time):
    """Position and quaternion (x y z w) by name, of the recorded frame nearest to a time."""
    with open(folder / "trajectory.csv", encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    nearest = min((float(row["time_s"]) for row in rows), key=lambda one: abs(one - time))
    number = lambda row, keys: [float(row[key]) for key in keys]  # noqa: E731
    return nearest, {row["body"]: (number(row, ("px_m", "py_m", "pz_m")), number(row, ("qx", "qy", "qz", "qw")))
                     for row in rows if float(row["time_s"]) == nearest}


def check_gltf(tumble):
    """Each node of a run of figure 6.6 is where the trajectory has its body, and not seen while that is not there."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "run"
        for words in (("run", "fig6_6", "--set", "rows=4", "--duration", "3", "--quiet", "--out", folder),
                      ("render", folder, "--as", "gltf")):
            subprocess.run([tumble, *words], check=True, stdout=subprocess.DEVNULL)
        recorded = [poses(folder, time) for time in TIMES]
        said = subprocess.run(["node", LIVE / "checks" / "gltf.mjs", folder / "film.gltf",
                               *(str(time) for time, _ in recorded)], capture_output=True, text=True, check=False)
        if said.returncode:
            yield f"three.js does not read it: {said.stderr.strip().splitlines()[-1]}"
            return
        read = json.loads(said.stdout)
    if abs(read["seconds"] - 3) > APART:
        yield f"the animation takes {read['seconds']} s instead of 3"
    for (time, bodies), nodes in zip(recorded, read["moments"]):
        for node in nodes:
            if node["name"] == "ground":
                continue
            if node["name"] not in bodies:
                if any(node["scale"]):
                    yield f"{node['name']} is seen at {time} s, when it is not there"
                continue
            position, quaternion = bodies.pop(node["name"])
            turned = abs(sum(a * b for a, b in zip(quaternion, node["quaternion"])))
            if math.dist(position, node["position"]) > APART or abs(turned - 1) > APART or not all(node["scale"]):
                yield f"{node['name']} at {time} s: {node} instead of {position}, {quaternion}"
        yield from (f"{name} is missing at {time} s" for name in bodies)
