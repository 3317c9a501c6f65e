"""A depth image in, objects out."""

import symscene

depth, intrinsics = symscene.example_depth()  # or a NumPy array and (fx, fy, cx, cy)
result = symscene.segment_depth(depth, intrinsics)
for item in result.objects:
    volume = 1e6 * item.solid.volume if item.solid else 0.0
    print(f"{item}: {volume:.0f} ml, {len(item.axes)} axes, {len(item.planes)} planes")
