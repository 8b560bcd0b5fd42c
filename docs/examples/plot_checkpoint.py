#!/usr/bin/env python3
# SPDX-License-Identifier: BSL-1.0
# plot_checkpoint.py CHECKPOINT PICTURE: the particles of a checkpoint, darker with every generation.
import sys
import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.collections import PolyCollection

with h5py.File(sys.argv[1]) as file:
    particles = file["simulation/particles"]
    rotation = particles["bodies/rotation/cosine"][:] + 1j * particles["bodies/rotation/sine"][:]
    position = particles["bodies/position"][:].view(complex)[:, 0]
    local = particles["local_vertices"][:].view(complex)[:, 0]  # in the particles' own frames
    first, count = particles["shapes/first"][:], particles["shapes/count"][:]
    generation = particles["ancestries/generation"][:].astype(float)
    time = file["simulation/time"][()]

places = [position[i] + rotation[i] * local[first[i] : first[i] + count[i]] for i in range(len(first))]
rings = [np.column_stack([ring.real, ring.imag]) for ring in places]
figure, axes = pyplot.subplots(figsize=(7, 7))
axes.add_collection(PolyCollection(rings, array=generation, cmap="Oranges", edgecolor="black", linewidth=0.4, clim=(-1, 4)))
axes.set(aspect="equal", xlabel="axis 1 [m]", ylabel="axis 2 [m]", title=f"{len(rings)} particles, t = {time:.4g} s")
axes.autoscale_view()
figure.savefig(sys.argv[2], dpi=110, bbox_inches="tight")
