// Properties of the viewer's modules that need no browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NO_POINT, coverage } from '../../viewer/src/coverage.js';
import { overlaps, placeLabels } from '../../viewer/src/declutter.js';
import { detailFor } from '../../viewer/src/gl/detail.js';
import { footprint } from '../../viewer/src/footprint.js';
import { gripperParts } from '../../viewer/src/gl/grippers.js';
import { drawnGrasps, failure, graspOf, graspsOfObject } from '../../viewer/src/grasps.js';
import { moveToTableFrame, tableFrame } from '../../viewer/src/frame.js';
import { HIDDEN, REST, pointOwners } from '../../viewer/src/ownership.js';
import { paintClosed } from '../../viewer/src/painting.js';
import { inkOn, objectColor, qualityColor } from '../../viewer/src/palette.js';
import { decodePayload } from '../../viewer/src/payload.js';
import { initialState } from '../../viewer/src/store.js';
import { dot, length } from '../../viewer/src/vector.js';
import { gainShare } from '../../viewer/src/views.js';
import { randomNumbers, tabletop } from './fixture.mjs';
import { encodeScene } from './payload.mjs';

test('planes are shown at first only where a table bounds the objects', () => {
  const shown = (table) => initialState({ objects: [], surface: null, grasps: null, table }).planes;
  assert.deepEqual([0.5, null].map(shown), [true, false]);
});

test('labels never cover each other, the controls or the border', () => {
  const random = randomNumbers(3);
  const area = { left: 0, top: 0, right: 600, bottom: 400 };
  const obstacles = [{ left: 0, top: 0, right: 300, bottom: 40 }];
  for (let round = 0; round < 50; ++round) {
    const labels = Array.from({ length: 25 }, () => ({ x: 600 * random(), y: 400 * random(), width: 26, height: 24 }));
    const boxes = placeLabels(labels, area, obstacles).filter(Boolean)
      .map(({ x, y }) => ({ left: x - 13, right: x + 13, top: y - 12, bottom: y + 12 }));
    for (const [i, a] of boxes.entries()) {
      assert.ok(a.left >= 0 && a.right <= 600 && a.top >= 0 && a.bottom <= 400);
      for (const b of [...obstacles, ...boxes.slice(0, i)]) assert.ok(!overlaps(a, b));
    }
  }
});

test('the visible object with the highest score owns a point of two masks', () => {
  const objects = [{ index: 0, points: [0, 1] }, { index: 1, points: [1, 2] }];
  const owners = (...on) => [...pointOwners(4, objects, (index) => on.includes(index))];
  assert.deepEqual(owners(0, 1), [0, 0, 1, REST]);
  assert.deepEqual(owners(1), [HIDDEN, 1, 1, REST]);
  assert.deepEqual(owners(0), [0, 0, HIDDEN, REST]);
  assert.deepEqual(owners(), [HIDDEN, HIDDEN, HIDDEN, REST]);
});

test('the display frame is rigid, with y up and the table at zero', () => {
  const scene = decodePayload(tabletop());
  const frame = tableFrame(scene);
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(frame.direction);
  for (const [i, a] of axes.entries()) {
    for (const [j, b] of axes.entries()) assert.ok(Math.abs(dot(a, b) - (i === j)) < 1e-12);
  }
  assert.ok(length(frame.direction([0, 0, 1]).map((v, i) => v - [0, 1, 0][i])) < 1e-12);
  assert.ok(Math.abs(frame.point([0.3, 0.2, 0])[1]) < 1e-12);
  assert.ok(frame.direction([0, -1, 0])[2] > 0.9, 'the camera stood at −y');
});

test('the footprint of a rotated rectangle is the rectangle', () => {
  const random = randomNumbers(5);
  const [c, s] = [Math.cos(0.5), Math.sin(0.5)];
  const points = Array.from({ length: 3000 }, () => {
    const [a, b] = [0.2 * random(), 0.1 * random()];
    return [c * a - s * b, 0.3 * random(), s * a + c * b];
  });
  const expected = [0.2, 0.1, 0.3];
  footprint(points).forEach((size, i) => assert.ok(Math.abs(size - expected[i]) < 0.015));
});

test('positions in steps of 16 bits decode to metres', () => {
  const data = Buffer.from(Uint16Array.from([0, 65535, 32768]).buffer).toString('base64');
  const empty = { positions: { encoding: 'f32', data: '' }, normals: '', colors: '' };
  const positions = { encoding: 'u16', data, min: [1, 2, 3], step: [1 / 65535, 1 / 65535, 0] };
  const { cloud } = decodePayload({ cloud: { ...empty, positions }, objects: [] });
  assert.deepEqual([...cloud.positions], [1, 3, 3]);
});

test('a surface takes owners from points on it with similar normals', () => {
  const surface = { positions: Float32Array.from([0, 0, 0, 0.006, 0, 0, 0.5, 0, 0, 0, -0.001, 0]) };
  const normals = Float32Array.from([0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0, 1]);
  const cloud = {
    count: 3,
    positions: Float32Array.from([0.001, 0, 0, 0.004, 0, 0, -0.5, 0, 0]),
    normals: Float32Array.from([0, 0, -1, 0, 0, 1, 0, 0, 1]),
  };
  const { nearest, covered } = coverage(surface, normals, cloud, 0.0055, -0.0005);
  assert.deepEqual([...nearest], [1, 0, NO_POINT, NO_POINT]);
  assert.deepEqual([...covered], [1, 1, 0]);
});

test('triangles decode to the vertices that were encoded', () => {
  const positions = Array.from({ length: 400 }, (_, i) => [i, 0, 0]);
  const triangles = [...positions.slice(2).map((_, i) => [i, i + 1, i + 2]), [399, 0, 200]];
  const scene = encodeScene({ cloud: { positions: [] }, surface: { positions, colors: [], triangles } });
  const { surface } = decodePayload(scene);
  const corners = [...surface.triangles].map((vertex) => surface.positions[3 * vertex]);
  assert.deepEqual(corners, triangles.flat());
});

test('consecutive objects have distinct colours and legible text', () => {
  for (let i = 0; i < 40; ++i) {
    const [a, b] = [objectColor(i), objectColor(i + 1)];
    assert.ok(Math.hypot(...a.map((value, k) => value - b[k])) > 60, `${i}`);
    assert.match(inkOn(a), /^#/);
  }
});

test('the inferred side of a closed surface is lighter than the observed one', () => {
  const object = decodePayload(tabletop({ closed: true })).objects[3];
  assert.ok(object.hasCompletion);
  const shades = [];
  paintClosed({ paint: (ownerOf, shadeOf) => {
    for (let i = 0; 3 * i < object.closed.positions.length; ++i) shades.push([ownerOf(i), shadeOf(i)]);
  } }, object);
  const sum = ([r, g, b]) => r + g + b;
  const observed = (i) => object.closed.colors[3 * i] > 127;
  assert.ok(shades.some((_, i) => observed(i)) && shades.some((_, i) => !observed(i)));
  shades.forEach(([owner, shade], i) => {
    assert.equal(owner, 3);
    assert.equal(sum(shade) > sum(objectColor(3)) + 100, !observed(i));
  });
});

test('grasps move with the scene into the display frame, and stay perpendicular', () => {
  const payload = tabletop({ grasps: {} });
  const before = structuredClone(payload.grasps);
  const scene = decodePayload(payload);
  const frame = tableFrame(scene);
  const { accepted, rejected } = moveToTableFrame(scene).grasps;
  assert.equal(accepted.length + rejected.length, before.accepted.length + before.rejected.length);
  accepted.forEach((grasp, i) => {
    assert.deepEqual(grasp.position, frame.point(before.accepted[i].position));
    assert.ok(Math.abs(dot(grasp.closing, grasp.approach)) < 1e-9 && Math.abs(length(grasp.approach) - 1) < 1e-9);
  });
});

test('views move with the scene into the display frame, and keep their gains', () => {
  const payload = tabletop({ views: true });
  const before = structuredClone(payload.views);
  const scene = decodePayload(payload);
  const frame = tableFrame(scene);
  moveToTableFrame(scene).views.list.forEach(({ camera, gain }, rank) => {
    assert.deepEqual(camera.position, frame.point(before.list[rank].camera.position));
    assert.ok(Math.abs(dot(camera.forward, camera.right)) < 1e-9);
    assert.equal(gain, before.list[rank].gain);
  });
});

test('the share of a gain is between 0 and 1, that of the best 1', () => {
  const { views } = tabletop({ views: true });
  assert.deepEqual(views.list.map((_, rank) => gainShare(views, rank)), [1, 0.75, 0.5, 0.25]);
  assert.equal(gainShare({ list: [{ gain: 0 }, { gain: -1 }] }, 1), 0);
});

test('the drawn grasps are the best of each visible object, or all of the selected one', () => {
  const { grasps } = tabletop({ grasps: {} });
  const state = { grasps: true, visible: new Set([0, 1, 3]), selected: null, grasp: null, hoveredGrasp: null };
  const objects = (changes) => drawnGrasps(grasps, { ...state, ...changes }).map(([key]) => graspOf(grasps, key).object);
  assert.deepEqual(objects({}), [0, 3]);
  assert.deepEqual(objects({ grasps: false }), []);
  assert.deepEqual(objects({ selected: 3 }), [3, 3, 3, 3, 3]);
  assert.deepEqual(objects({ selected: 1 }), [], 'it has none');
  assert.deepEqual(objects({ selected: 5 }), [0, 3], 'a hidden object counts as not selected');
  const [{ key: rejected }] = graspsOfObject(grasps, 3, 'r');
  for (const changes of [{ grasp: rejected }, { hoveredGrasp: rejected }]) {
    assert.deepEqual(drawnGrasps(grasps, { ...state, selected: 3, ...changes }).at(-1), [rejected, 'strong']);
  }
  const [{ key: foreign }] = graspsOfObject(grasps, 0, 'a');
  assert.ok(drawnGrasps(grasps, { ...state, selected: 3, grasp: foreign }).every(([key]) => key !== foreign));
  for (const key of [null, undefined, '', 'a', 'a999', 'x1']) assert.equal(graspOf(grasps, key), null);
});

test('a gripper has its pads as far apart as the object is wide, and as many fingers as its kind', () => {
  const gripper = { kind: 'parallel', max_opening: 0.08, finger_spacing: 0 };
  const places = (kind, opening) => gripperParts({ ...gripper, kind, finger_spacing: 0.05 }, opening)
    .filter(({ part }) => part !== 'palm').map(({ at }) => at);
  assert.deepEqual(places('parallel', 0.06), [[0, 0.03, 0], [0, -0.03, 0]]);
  assert.deepEqual(places('three_finger', 0.06), [[-0.025, 0.03, 0], [0.025, 0.03, 0], [0, -0.03, 0]]);
  assert.deepEqual(places('parallel', 0.2), [[0, 0.04, 0], [0, -0.04, 0]], 'never wider than it opens');
});

test('a failed bound is told with its value, lengths in millimetres', () => {
  assert.equal(failure({ reason: 'too_wide', value: 0.0921, bound: 0.08 }), '92.1 mm > 80.0 mm');
  assert.equal(failure({ reason: 'friction', value: 0.9, bound: 0.7 }), '0.900 > 0.700');
  assert.equal(failure({ reason: 'table', value: null, bound: 0.002 }), '– < 2.0 mm');
});

test('qualities from 0 to 1 have distinct colours, and others those of the ends', () => {
  const colors = Array.from({ length: 11 }, (_, i) => qualityColor(i / 10).join());
  assert.equal(new Set(colors).size, 11);
  assert.deepEqual(qualityColor(-1), qualityColor(0));
  assert.deepEqual(qualityColor(2), qualityColor(1));
  assert.deepEqual(qualityColor(null), qualityColor(0));
});

test('the slower a frame, the coarser are pictures and the later comes the still one, within bounds', () => {
  const details = [0, 1, 5, 20, 50, 200, 1000, 10000].map(detailFor);
  assert.deepEqual(details[0], { motionScale: 1, restSamples: 2, restDelay: 140 });
  assert.deepEqual(details.at(-1), { motionScale: 0.4, restSamples: 1, restDelay: 800 });
  details.slice(1).forEach((slower, i) => {
    assert.ok(slower.motionScale <= details[i].motionScale && slower.restSamples <= details[i].restSamples);
    assert.ok(slower.restDelay >= details[i].restDelay);
  });
});
