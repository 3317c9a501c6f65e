"""Objects and their completed meshes, drawn by Matplotlib into a window, or into a file."""

import sys

import matplotlib.pyplot as plt
import symscene

result = symscene.segment_depth(*symscene.example_depth(), object_surface={"voxel_size": 0.01})
axes = plt.figure(figsize=(8, 8)).add_subplot(projection="3d")
for item in result.objects:
    axes.scatter(*item.points.T, s=2)
    if item.mesh:
        axes.plot_trisurf(*item.mesh.vertices.T, triangles=item.mesh.triangles, alpha=0.3)
axes.view_init(elev=-50, azim=-90)
axes.set(xlabel="x [m]", ylabel="y [m]", zlabel="z [m]", aspect="equal")
plt.savefig(sys.argv[1]) if len(sys.argv) > 1 else plt.show()
