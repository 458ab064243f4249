# %% [markdown]
# From files to a plot: a model of surfaces on disk, its modes, and how the training shapes lie in it.
# Run it as a script (`python3 from_files_to_plot.py FOLDER [SHAPES]`) or cell by cell in an editor that knows `# %%`.

# %%
import pathlib
import sys

import numpy as np

import foramen

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "example")
folder.mkdir(parents=True, exist_ok=True)

# %% [markdown]
# Surfaces of your own, or a synthetic cohort.

# %%
if len(sys.argv) > 2:
    shapes = pathlib.Path(sys.argv[2])
else:
    shapes = folder / "shapes"
    shapes.mkdir(exist_ok=True)
    for i, (surface, _) in enumerate(foramen.synth(5, seed=3, vertices=2500)):
        foramen.write_mesh(shapes / f"vertebra{i + 1}.ply", surface)

# %% [markdown]
# Are they usable? Then the model; `progress` is called as it goes.

# %%
for path in sorted(shapes.glob("*.ply")):
    report = foramen.inspect(foramen.read_mesh(path))
    print(path.name, "usable" if report["usable"] else report["finding"])

foramen.build(shapes, folder / "model", landmarks=500, samples=20,
              progress=lambda stage, fraction, item: print(f"\r{stage:20} {fraction:4.0%} {item:20}", end=""))
print()
model = foramen.Model.load(folder / "model")

# %% [markdown]
# What the modes explain, where the training shapes lie, and how far the first mode moves each landmark.

# %%
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
left.plot(np.arange(1, model.modes + 1), model.variance.cumsum() / model.variance.sum(), "o-")
left.set(xlabel="modes", ylabel="explained variance", ylim=(0, 1.05))
middle.scatter(model.scores[:, 0], model.scores[:, 1])
for name, (x, y) in zip(model.names, model.scores[:, :2]):
    middle.annotate(name, (x, y), fontsize=8)
middle.set(xlabel="mode 1 (sd)", ylabel="mode 2 (sd)")
moved = np.linalg.norm(model.along_mode(0, 2) - model.mean, axis=1)
points = right.scatter(model.mean[:, 0], model.mean[:, 2], c=moved, s=6)
right.set(xlabel="x (mm)", ylabel="z (mm)", aspect="equal")
figure.colorbar(points, ax=right, label="moved by mode 1 at 2 sd (mm)")
figure.savefig(folder / "model.png", dpi=110)
print("wrote", folder / "model.png", "and", folder / "model" / "report.html")
