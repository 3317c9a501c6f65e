"""Depth frames of a moving camera, one by one: a scene, its objects, their grasps."""

import symscene

depths, _, intrinsics = symscene.example_sweep()
reconstruction = symscene.Reconstruction(intrinsics)
for depth in depths:
    report = reconstruction.add(depth)
    print(report.status, report.T_world_camera[:3, 3].round(3))
scene = reconstruction.scene()
result = symscene.segment(scene)
plan = symscene.grasps(result, "panda")
for item, reason in zip(result.objects, plan.reasons):
    count = sum(grasp.object == item.id for grasp in plan.grasps)
    print(item, f"{count} grasps" if reason is None else f"no grasp: {reason}")
